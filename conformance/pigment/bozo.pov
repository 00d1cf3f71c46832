// bozo noise.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z look_at 0 right 8*x up 6*y }
box { <-4, -3, 0>, <4, 3, 1> pigment { bozo color_map { [0 rgb <0.1, 0.2, 0.6>] [1 rgb <1, 1, 0.8>] } scale 0.8 }  finish { ambient 1 diffuse 0 } }
