// Scaling an object scales its bumps, unless no_bump_scale says otherwise.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
sphere { 0, 0.3 pigment { rgb <0.7, 0.7, 0.75> } finish { phong 0.6 phong_size 30 } normal { bumps 0.5 scale 0.05 } scale 3.5 translate -1.3*x }
sphere { 0, 0.3 pigment { rgb <0.7, 0.7, 0.75> } finish { phong 0.6 phong_size 30 } normal { bumps 0.5 scale 0.05 no_bump_scale } scale 3.5 translate 1.3*x }
