// A flat and a smooth triangle.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
triangle { <-2.4, -1, 0>, <-0.2, -1, 0>, <-1.3, 1.2, 0> pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
smooth_triangle { <0.2, -1, 0>, <-1, -1, -1>, <2.4, -1, 0>, <1, -1, -1>, <1.3, 1.2, 0>, <0, 1, -1> pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
