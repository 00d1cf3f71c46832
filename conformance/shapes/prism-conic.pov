// A conic prism with a quadratic outline.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
prism { conic_sweep quadratic_spline 0.3, 1, 6 <1, -1>, <1, 1>, <-1, 1>, <-1, -1>, <1, -1>, <1, 1> scale <1, 2, 1> translate -y rotate <-20, 30, 0> pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
