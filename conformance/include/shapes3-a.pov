// Macros of shapes3.inc.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "shapes3.inc"
camera { orthographic location -10 * z look_at 0 right 8 * x up 6 * y }
light_source { <3, 6, -9> rgb 0.9 }
#declare Thing = object { Segment_of_Torus(1, 0.25, 145) }
object { Thing scale 0.85 rotate <-30, 25, 0> translate <-2.6, 2, 0> pigment { rgb <0.8, 0.7, 0.6> } }
#declare Thing = object { Segment_of_CylinderRing(1, 0.55, 0.5, -235) }
object { Thing scale 0.85 rotate <-30, 25, 0> translate <0, 2, 0> pigment { rgb <0.8, 0.7, 0.6> } }
#declare Thing = object { Segment_of_Object(box { <-1, -0.5, -0.7>, <1.2, 0.6, 0.8> }, 200) }
object { Thing scale 0.85 rotate <-30, 25, 0> translate <2.6, 2, 0> pigment { rgb <0.8, 0.7, 0.6> } }
#declare Thing = object { Column_N_AB(5, <-0.5, 0, -0.3>, <0.8, 1, 0.2>, 0.5) }
object { Thing scale 0.85 rotate <-30, 25, 0> translate <-2.6, 0, 0> pigment { rgb <0.8, 0.7, 0.6> } }
#declare Thing = object { Pyramid_N_AB(6, <-0.5, 0, -0.3>, 0.75, <0.8, 1, 0.2>, 0.2) }
object { Thing scale 0.85 rotate <-30, 25, 0> translate <0, 0, 0> pigment { rgb <0.8, 0.7, 0.6> } }
#declare Thing = object { Facetted_Sphere(3, 8) }
object { Thing scale 0.85 rotate <-30, 25, 0> translate <2.6, 0, 0> pigment { rgb <0.8, 0.7, 0.6> } }
#declare Thing = object { Facetted_Egg(5, 8) }
object { Thing scale 0.85 rotate <-30, 25, 0> translate <-2.6, -2, 0> pigment { rgb <0.8, 0.7, 0.6> } }
#declare Thing = object { Egg_Shape(1.3, 0.55) }
object { Thing scale 0.85 rotate <-30, 25, 0> translate <0, -2, 0> pigment { rgb <0.8, 0.7, 0.6> } }
#declare Thing = object { Ring_Sphere(1, 1.1, 0.055, 0.03, 5, 7) }
object { Thing scale 0.85 rotate <-30, 25, 0> translate <2.6, -2, 0> pigment { rgb <0.8, 0.7, 0.6> } }
