// A camera below a height field and a disc stands in neither: the fog is seen.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, -3, -6> look_at <0, -3, 0> angle 60 }
light_source { <20, 50, -30> 1 }
fog { distance 12 color rgb <0.4, 0.5, 0.8> }
height_field { function 16, 16 { x*z } translate -0.5 scale <20, 2, 20> pigment { rgb <0.8, 0.7, 0.3> } }
disc { <0, 6, 0>, y, 30 pigment { rgb <0.3, 0.8, 0.3> } }
sphere { <0, -3, 0>, 1 pigment { rgb 1 } }
sphere { <3, -3, 9>, 2 pigment { rgb <1, 0.3, 0.2> } }
plane { y, -6 pigment { checker rgb 0.2 rgb 0.9 } }
