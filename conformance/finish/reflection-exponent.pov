// Reflection with an exponent, a falloff, and both with a range.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -4> look_at 0 angle 35 }
light_source { <3, 5, -6>, rgb 1 }
plane { y, -0.8 pigment { checker rgb 0.1, rgb <0.9, 0.8, 0.6> scale 0.4 } }
sphere { <-1.15, 0, 0>, 0.55 pigment { rgb <0.1, 0.2, 0.4> } finish { reflection { 0.8 exponent 0.5 } } }
sphere { <0, 0, 0>, 0.55 pigment { rgb <0.1, 0.2, 0.4> } finish { reflection { 0.1, 0.9 falloff 3 } } }
sphere { <1.15, 0, 0>, 0.55 pigment { rgb <0.1, 0.2, 0.4> } finish { reflection { 0.9 } reflection_exponent 2 } }
