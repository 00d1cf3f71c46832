// error[srgb-without-gamma] 3:25 assumed_gamma
#version 3.7;
sphere { 0, 1 pigment { srgb <1, 0, 0> } }
