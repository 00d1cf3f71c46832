// turbulence with octaves, lambda and omega.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z look_at 0 right 8*x up 6*y }
box { <-4, -3, 0>, <4, 3, 1> pigment { gradient x turbulence <0.8, 0.4, 0> octaves 3 lambda 2.5 omega 0.6 color_map { [0 rgb 1] [0.5 rgb <0, 0.3, 0.7>] [1 rgb 1] } scale 2 }  finish { ambient 1 diffuse 0 } }
