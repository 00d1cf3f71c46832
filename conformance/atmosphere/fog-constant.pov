// Constant fog with filter and transmit.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
fog { fog_type 1 distance 8 rgbft <0.7, 0.75, 0.8, 0.2, 0.1> }
plane { y, -1 pigment { checker rgb <0.8, 0.3, 0.2>, rgb 0.9 } }
sphere { <0, 0, 1>, 1 pigment { rgb <0.2, 0.4, 0.9> } }
