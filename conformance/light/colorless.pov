// A light without a colour is black, and so is the word `color` with nothing behind it.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -5> look_at 0 }
light_source { <-5, 5, -5> }
light_source { <5, 5, -5> parallel }
light_source { <0, 5, -5> rgb 0.7 }
sphere { -x, 1 pigment { rgb 1 } }
sphere { x, 1 pigment { color } finish { specular 0.8 } }
