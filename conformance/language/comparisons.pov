// Comparisons go from left to right and yield 1 or 0; the conditional operator.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
sphere { -2*x, (3 > 2 > 1) + 0.3 pigment { rgb <1, 0, 0> } }
sphere { 0, (1 < 2 & 2 < 3) - 0.3 pigment { rgb <0, 1, 0> } }
sphere { 2*x, (1e-11 = 0 ? 0.8 : 0.2) pigment { rgb <0, 0, 1> } }
