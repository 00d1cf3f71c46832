// Grain, which is drawn anew for every pixel.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -4> look_at 0 angle 35 }
light_source { <3, 5, -6>, rgb 1 }
sphere { 0, 0.9 pigment { rgb <0.8, 0.6, 0.4> } finish { crand 0.02 } }
plane { y, -0.9 pigment { rgb 0.6 } finish { crand 0.01 } }
