// Things that stay at their place on the screen.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "screen.inc"
Set_Camera(<3, 2, -6>, <0, 0.5, 0>, 50)
Set_Camera_Aspect(4, 3)
light_source { <3, 5, -6> rgb 1 }
light_source { <3.6, 2.4, -9> rgb <0.3, 0.5, 0.9> }
fog { distance 12 rgb <0.5, 0.6, 0.8> }
plane { y, 0 pigment { rgb 0.8 } }
sphere { y, 1 pigment { rgb <0.9, 0.4, 0.3> } }
Screen_Object(sphere { 0, 0.1 pigment { rgb <0.2, 0.9, 0.3> } }, <1, 1>, 0.02, true, 0.3)
Screen_Object(box { <-0.1, -0.05, -0.02>, <0.2, 0.05, 0.02> pigment { rgb <0.2, 0.4, 0.9> } }, <0, 0.3>, <0.02, 0.05>, false, 0.5)
Screen_Plane(texture { pigment { gradient y color_map { [0 rgb <1, 0, 0>] [1 rgbt <1, 1, 0, 0.5>] } } finish { ambient 1 diffuse 0 } }, 0.02, <0.1, 0.05>, <0.5, 0.25>)
