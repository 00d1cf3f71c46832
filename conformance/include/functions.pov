// functions.inc: built-in functions as isosurfaces.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "functions.inc"
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
isosurface { function { f_rounded_box(x, y, z, 0.2, 0.7, 0.7, 0.7) } contained_by { box { -0.8, 0.8 } } max_gradient 1.5 rotate <20, 30, 0> translate -1.4*x pigment { rgb <0.8, 0.4, 0.3> } }
isosurface { function { f_torus(x, y, z, 0.7, 0.3) + 0.1*f_noise3d(x*5, y*5, z*5) } contained_by { box { <-1.1, -0.4, -1.1>, <1.1, 0.4, 1.1> } } max_gradient 2 rotate -50*x translate 1.4*x pigment { rgb <0.4, 0.5, 0.9> } }
