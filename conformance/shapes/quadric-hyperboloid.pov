// A quadric: a hyperboloid of one sheet, clipped.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
quadric { <1, -1, 1>, 0, 0, -0.3 clipped_by { box { <-2, -1.3, -2>, <2, 1.3, 2> } } rotate -20*x pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
