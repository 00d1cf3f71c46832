// gradient with a colour map that does not begin at 0.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z look_at 0 right 8*x up 6*y }
box { <-4, -3, 0>, <4, 3, 1> pigment { gradient <1, 1, 0> color_map { [0.2 rgb <1, 0, 0>] [0.5 rgb <1, 1, 0>] [0.5 rgb <0, 0, 1>] [0.9 rgb <0, 1, 1>] } }  finish { ambient 1 diffuse 0 } }
