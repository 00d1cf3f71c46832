// sunpos.inc: the shadows of three places and times.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "sunpos.inc"
camera { location <0, 8, -6> look_at 0 angle 50 }
light_source { SunPos(2000, 6, 21, 12, 2, 0, 51.4667, 0), rgb <1, 0.2, 0.2> }
light_source { SunPos(2024, 2, 29, 9, 30, 15, 45, 9.2), rgb <0.2, 1, 0.2> }
light_source { SunPos(1987, 12, 31, 16, 50, -75, -33.5, -70), rgb <0.2, 0.2, 1> }
plane { y, 0 pigment { rgb 1 } }
cylinder { 0, 1.5*y, 0.15 pigment { rgb 1 } }
box { <Az/400, 0, 1>, <Az/400 + 0.3, Al/60, 1.3> pigment { rgb 1 } }
