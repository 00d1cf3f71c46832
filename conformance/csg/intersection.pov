// The common part of a box and a sphere.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
intersection { box { -1, 1 } sphere { 0, 1.3 pigment { rgb <0.3, 0.5, 0.9> } } rotate <20, 30, 0> pigment { rgb <0.9, 0.7, 0.2> } }
