// filter and transmit in front of a board.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
plane { z, 2 pigment { checker rgb 0.95, rgb <0.1, 0.1, 0.4> } }
sphere { -2*x, 0.9 pigment { rgbf <1, 0.5, 0.3, 0.8> } }
sphere { 0*x, 0.9 pigment { rgbt <1, 0.5, 0.3, 0.8> } }
sphere { 2*x, 0.9 pigment { rgbft <1, 0.5, 0.3, 0.4, 0.4> } }
