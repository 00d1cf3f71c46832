// merge removes the surfaces inside, union keeps them.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
plane { z, 4 pigment { checker rgb 0.9, rgb 0.2 } }
union { sphere { -0.4*x, 0.8 } sphere { 0.4*x, 0.8 } translate -1.4*x pigment { rgbt <0.6, 0.8, 1, 0.6> } }
merge { sphere { -0.4*x, 0.8 } sphere { 0.4*x, 0.8 } translate 1.4*x pigment { rgbt <0.6, 0.8, 1, 0.6> } }
