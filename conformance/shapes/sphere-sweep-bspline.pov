// A sphere sweep along a B-spline.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
sphere_sweep { b_spline 6, <-3, -1, 0>, 0.3, <-2, -0.8, 0>, 0.4, <-0.8, 1.4, 0>, 0.5, <0.7, -1.2, 0.5>, 0.3, <2, 0.7, 0>, 0.4, <3, 1, 0>, 0.4 pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
