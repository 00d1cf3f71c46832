// image_map from a function, interpolated and not, repeated.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z look_at 0 right 8*x up 6*y }
box { <-4, -3, 0>, <0, 3, 1> pigment { image_map { function 6, 6 { 0.5 + 0.5*sin(7*x)*cos(5*y) } } scale 3 } finish { ambient 1 diffuse 0 } }
box { <0, -3, 0>, <4, 3, 1> pigment { image_map { function 6, 6 { 0.5 + 0.5*sin(7*x)*cos(5*y) } interpolate 2 once } scale 5 translate <-0.5, -2.5, 0> } finish { ambient 1 diffuse 0 } }
