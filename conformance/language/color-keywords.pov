// Colours in parts: red, green, blue, filter, transmit, rgbf, rgbt, and members.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
#declare A = color red 0.9 green 0.4;
sphere { -2*x, 0.9 pigment { color A } }
sphere { 0*x, 0.9 pigment { color rgbt <0.2, 0.9, 0.3, 0.5> } }
sphere { 2*x, 0.9 pigment { rgb <A.green, A.red, A.blue> } }
plane { z, 3 pigment { checker rgb 0.9, rgb 0.3 } }
