// A difference shows the cutter's texture in the cut.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
difference { box { -1, 1 } sphere { <1, 1, -1>, 1.1 pigment { rgb <0.9, 0.2, 0.2> } } cylinder { -2*z, 2*z, 0.4 } rotate <20, 30, 0> pigment { rgb <0.7, 0.7, 0.8> } }
