// shapes.inc: round boxes, cylinders and cones.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "shapes.inc"
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
object { Round_Box(<-0.7, -0.7, -0.7>, <0.7, 0.7, 0.7>, 0.2, no) rotate <20, 30, 0> translate -2*x pigment { rgb <0.8, 0.4, 0.3> } }
object { Round_Cylinder(-0.8*y, 0.8*y, 0.7, 0.25, no) rotate -30*x pigment { rgb <0.4, 0.7, 0.4> } }
object { Round_Cone2(-0.6*y, 0.7, 0.7*y, 0.3, no) translate 2*x pigment { rgb <0.4, 0.5, 0.9> } }
