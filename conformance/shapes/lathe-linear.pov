// A lathe of straight pieces.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
lathe { linear_spline 6, <0, -1.4>, <0.9, -1.2>, <0.3, -0.6>, <0.5, 0.6>, <1.1, 1>, <0.9, 1.3> rotate -15*x pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
