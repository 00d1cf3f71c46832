// A light group lights its own objects only.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <-3, 4, -4>, rgb 0.5 }
light_group { light_source { <3, 4, -4>, rgb <1, 0.5, 0> } sphere { -1.2*x, 0.8 pigment { rgb 0.8 } } global_lights on }
sphere { 1.2*x, 0.8 pigment { rgb 0.8 } }
plane { y, -1 pigment { rgb 0.8 } }
