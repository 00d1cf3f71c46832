// A union shares a texture; parts with their own keep it.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
union { sphere { -x, 0.9 } box { <0.2, -0.8, -0.8>, <1.8, 0.8, 0.8> pigment { rgb <0.3, 0.8, 0.3> } } rotate y*25 pigment { rgb <0.9, 0.5, 0.2> } }
