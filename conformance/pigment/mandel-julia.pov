// Escape-time fractals with exterior and interior colouring.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z look_at 0 right 8*x up 6*y }
box { <-4, -3, 0>, <0, 3, 1> pigment { mandel 40 exterior 1, 1.5 interior 1, 1 color_map { [0 rgb 0] [0.3 rgb <1, 0.4, 0>] [1 rgb 1] } scale 1.2 translate <-1.4, 0, 0> } finish { ambient 1 diffuse 0 } }
box { <0, -3, 0>, <4, 3, 1> pigment { julia <0.353, 0.288>, 30 exterior 4, 0.4 color_map { [0 rgb <0, 0, 0.3>] [1 rgb <0.8, 1, 1>] } scale 1.2 translate <2, 0, 0> } finish { ambient 1 diffuse 0 } }
