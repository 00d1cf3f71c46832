// rad_def.inc, stdinc.inc.
#version 3.7;
#include "stdinc.inc"
#include "rad_def.inc"
global_settings { assumed_gamma 1 radiosity { Rad_Settings(Radiosity_Fast, off, off) } }
camera { location <0, 1, -4> look_at 0.4*y }
background { rgb 1 }
plane { y, 0 pigment { rgb <1, 0.7, 0.5> } }
sphere { 0.5*y, 0.5 pigment { White } }
box { <1, 0, 0>, <1.5, 1, 1> pigment { SkyBlue } }
