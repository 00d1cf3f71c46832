// options: +A0.1 +AM1 +R3 -J
// Anti-aliasing method 1 without jitter.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
plane { y, -1 pigment { checker rgb 1, rgb 0 } }
sphere { 0, 1 pigment { rgb <0.9, 0.2, 0.2> } }
