// no_shadow on one of two spheres.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 4, -4>, rgb 1 }
plane { y, -1 pigment { rgb 0.8 } }
sphere { -1.2*x, 0.8 no_shadow pigment { rgb <0.9, 0.3, 0.3> } }
sphere { 1.2*x, 0.8 pigment { rgb <0.3, 0.3, 0.9> } }
