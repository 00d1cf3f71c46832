// crackle with forms, metric and solid.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z look_at 0 right 8*x up 6*y }
box { <-4, -3, 0>, <-1.3, 3, 1> pigment { crackle scale 0.8 color_map { [0 rgb 0] [0.3 rgb <0.9, 0.6, 0.3>] [1 rgb 1] } } finish { ambient 1 diffuse 0 } }
box { <-1.3, -3, 0>, <1.3, 3, 1> pigment { crackle form <1, 0, 0> metric 1 scale 0.8 color_map { [0 rgb 0] [1 rgb <0.5, 0.8, 1>] } } finish { ambient 1 diffuse 0 } }
box { <1.3, -3, 0>, <4, 3, 1> pigment { crackle solid scale 0.8 color_map { [0 rgb <1, 0, 0>] [0.5 rgb <0, 1, 0>] [1 rgb <0, 0, 1>] } } finish { ambient 1 diffuse 0 } }
