// Ground fog.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
fog { fog_type 2 distance 3 rgb 0.8 fog_offset -0.6 fog_alt 0.4 }
plane { y, -1 pigment { checker rgb <0.8, 0.3, 0.2>, rgb 0.2 } }
sphere { <0, 0, 1>, 1 pigment { rgb <0.2, 0.4, 0.9> } }
cylinder { <2, -1, 2>, <2, 1.5, 2>, 0.3 pigment { rgb <0.9, 0.8, 0.2> } }
