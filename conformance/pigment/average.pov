// average of weighted pigments.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z look_at 0 right 8*x up 6*y }
box { <-4, -3, 0>, <4, 3, 1> pigment { average pigment_map { [2 gradient x color_map { [0 rgb 0] [1 rgb <1, 0.5, 0>] }] [1 gradient y color_map { [0 rgb <0, 0, 1>] [1 rgb 1] }] } }  finish { ambient 1 diffuse 0 } }
