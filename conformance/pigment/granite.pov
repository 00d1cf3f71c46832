// granite.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z look_at 0 right 8*x up 6*y }
box { <-4, -3, 0>, <4, 3, 1> pigment { granite color_map { [0 rgb 0.1] [0.4 rgb <0.7, 0.4, 0.3>] [1 rgb 1] } scale 2 }  finish { ambient 1 diffuse 0 } }
