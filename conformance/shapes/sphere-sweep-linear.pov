// A sphere sweep along straight pieces with changing radius.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
sphere_sweep { linear_spline 4, <-2, -0.8, 0>, 0.3, <-0.8, 0.9, 0>, 0.5, <0.7, -0.6, 0.5>, 0.2, <2, 0.7, 0>, 0.4 pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
