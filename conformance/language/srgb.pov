// srgb colours are decoded; rgb colours are not.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
background { rgb 0.1 }
sphere { -1.2*x, 1 pigment { rgb <0.5, 0.3, 0.1> } finish { ambient 1 diffuse 0 } }
sphere { 1.2*x, 1 pigment { srgb <0.5, 0.3, 0.1> } finish { ambient 1 diffuse 0 } }
