// A function as a pattern.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z look_at 0 right 8*x up 6*y }
box { <-4, -3, 0>, <4, 3, 1> pigment { function { abs(sin(x*2)*cos(y*3)) } color_map { [0 rgb <0.1, 0, 0.2>] [0.7 rgb <1, 0.4, 0>] [1 rgb 1] } }  finish { ambient 1 diffuse 0 } }
