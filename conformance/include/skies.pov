// skies.inc and stars.inc: a sky sphere, clouds on spheres, star fields.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "colors.inc"
#include "skies.inc"
#include "stars.inc"
camera { location <0, 1, -6> look_at <0, 2, 0> angle 60 }
light_source { <3, 5, -6>, rgb 1 }
sky_sphere { S_Cloud1 }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.3 } }
sphere { -2*x, 0.9 texture { T_Cloud1 scale 0.2 } }
sphere { 0*x, 0.9 texture { T_Cloud3 scale 0.2 } }
sphere { 2*x, 0.9 texture { Starfield6 scale 0.3 } }
