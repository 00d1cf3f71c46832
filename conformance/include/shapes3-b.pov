// Macros of shapes3.inc.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "shapes3.inc"
camera { orthographic location -10 * z look_at 0 right 8 * x up 6 * y }
light_source { <3, 6, -9> rgb 0.9 }
#declare Thing = object { Round_Pyramid_N_out(5, <0, -0.5, 0>, 0.95, <0, 0.5, 0>, 0.5, 0.1, 1, 0) }
object { Thing scale 0.85 rotate <-30, 25, 0> translate <-2.6, 2, 0> pigment { rgb <0.8, 0.7, 0.6> } }
#declare Thing = object { Round_Pyramid_N_in(4, <-0.5, -0.4, -0.3>, 0.75, <0.8, 0.6, 0.2>, 0.3, 0.07, 0, 0) }
object { Thing scale 0.85 rotate <-30, 25, 0> translate <0, 2, 0> pigment { rgb <0.8, 0.7, 0.6> } }
#declare Thing = object { Round_Cylinder_Tube(<-0.5, -0.4, -0.3>, <0.8, 0.6, 0.2>, 0.7, 0.1, 0, 0) }
object { Thing scale 0.85 rotate <-30, 25, 0> translate <2.6, 2, 0> pigment { rgb <0.8, 0.7, 0.6> } }
#declare Thing = object { Rounded_Tube_AB(<-0.5, -0.4, -0.3>, <0.8, 0.6, 0.2>, 0.7, 0.3, 0.15, 0) }
object { Thing scale 0.85 rotate <-30, 25, 0> translate <-2.6, 0, 0> pigment { rgb <0.8, 0.7, 0.6> } }
#declare Thing = object { Round_Conic_Torus(1, 0.3, 0.6, 0.15, 0) }
object { Thing scale 0.85 rotate <-30, 25, 0> translate <0, 0, 0> pigment { rgb <0.8, 0.7, 0.6> } }
#declare Thing = object { Round_Conic_Prism(1, 0.3, 0.6, 0.8, 0.1, 0) }
object { Thing scale 0.85 rotate <-30, 25, 0> translate <2.6, 0, 0> pigment { rgb <0.8, 0.7, 0.6> } }
#declare Thing = object { Half_Hollowed_Rounded_Cylinder1(2.2, 0.7, 0.2, 0.7, 0) }
object { Thing scale 0.85 rotate <-30, 25, 0> translate <-2.6, -2, 0> pigment { rgb <0.8, 0.7, 0.6> } }
#declare Thing = object { Half_Hollowed_Rounded_Cylinder2(2.2, 0.7, 0.3, 0.1, 0.7, 0) }
object { Thing scale 0.85 rotate <-30, 25, 0> translate <0, -2, 0> pigment { rgb <0.8, 0.7, 0.6> } }
#declare Thing = object { Round_N_Tube_Polygon(5, 0.12, 0.8, 0.3, 0, 0) }
object { Thing scale 0.85 rotate <-30, 25, 0> translate <2.6, -2, 0> pigment { rgb <0.8, 0.7, 0.6> } }
