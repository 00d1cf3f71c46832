// pigment_map blends patterns.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z look_at 0 right 8*x up 6*y }
box { <-4, -3, 0>, <4, 3, 1> pigment { gradient x pigment_map { [0 checker rgb 0.9, rgb 0.2 scale 0.5] [0.5 rgb <0.8, 0.2, 0.2>] [1 bozo color_map { [0 rgb <0, 0, 1>] [1 rgb 1] } scale 0.3] } scale 8 translate -4*x }  finish { ambient 1 diffuse 0 } }
