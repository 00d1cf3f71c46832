// ambient, diffuse and emission.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
sphere { -2*x, 0.9 pigment { rgb <0.8, 0.4, 0.2> } finish { ambient 0.5 diffuse 0.2 } }
sphere { 0*x, 0.9 pigment { rgb <0.8, 0.4, 0.2> } finish { ambient 0 diffuse 1 } }
sphere { 2*x, 0.9 pigment { rgb <0.8, 0.4, 0.2> } finish { ambient 0 diffuse 0.3 emission 0.4 } }
