// A lathe of Bezier pieces.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
lathe { bezier_spline 8, <0.2, -1.4>, <1.6, -1.2>, <1, -0.4>, <0.4, -0.2>, <0.4, -0.2>, <0.1, 0.4>, <0.8, 1>, <0.9, 1.4> rotate -15*x pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
