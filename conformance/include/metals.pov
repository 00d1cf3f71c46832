// metals.inc and golds.inc.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "metals.inc"
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.3 } }
sphere { -2*x, 0.9 texture { T_Gold_3C } }
sphere { 0*x, 0.9 texture { T_Chrome_4D } }
sphere { 2*x, 0.9 texture { T_Copper_2B } }
