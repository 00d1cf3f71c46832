// leopard, onion and radial with a frequency.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z look_at 0 right 8*x up 6*y }
box { <-4, -3, 0>, <-1.3, 3, 1> pigment { leopard scale 0.15 color_map { [0 rgb <0.9, 0.7, 0.3>] [1 rgb 0] } } finish { ambient 1 diffuse 0 } }
box { <-1.3, -3, 0>, <1.3, 3, 1> pigment { onion scale 0.5 color_map { [0 rgb <0.2, 0.5, 0.2>] [1 rgb 1] } } finish { ambient 1 diffuse 0 } }
box { <1.3, -3, 0>, <4, 3, 1> pigment { radial frequency 6 rotate 90*x translate <2.7, 0, 0> color_map { [0 rgb <1, 0.5, 0>] [1 rgb <0, 0, 0.4>] } } finish { ambient 1 diffuse 0 } }
