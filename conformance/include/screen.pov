// screen.inc: objects and a texture right before the camera.
#version 3.7; global_settings { assumed_gamma 1 }
#include "screen.inc"
Set_Camera(<3,2,-6>, <0,.5,0>, 55)
Set_Camera_Sky(<.1,1,0>)
light_source { <10,20,-30> rgb 1 }
plane { y, 0 pigment { checker rgb 1 rgb .4 } }
sphere { y, 1 pigment { rgb <.8,.2,.1> } }
Screen_Object(sphere { 0, .1 pigment { rgb <0,1,0> } }, <1,0>, <.02,.02>, true, .01)
Screen_Object(box { 0, .1 pigment { rgb <0,1,1> } }, <.1,.9>, <.02,.02>, false, .01)
Screen_Object(cylinder { 0, .1*y,.03 pigment { rgb <0,0,1> } }, <0,1>, .05, true, .01)
Screen_Plane(texture { pigment { gradient x } finish { ambient 1 diffuse 0 } }, .01, <.3,.05>, <.6,.2>)
