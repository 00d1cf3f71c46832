// marble and wood with turbulence.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z look_at 0 right 8*x up 6*y }
box { <-4, -3, 0>, <0, 3, 1> pigment { marble turbulence 0.6 color_map { [0 rgb 1] [0.8 rgb <0.3, 0.3, 0.5>] [1 rgb 0] } } finish { ambient 1 diffuse 0 } }
box { <0, -3, 0>, <4, 3, 1> pigment { wood turbulence 0.1 color_map { [0 rgb <0.7, 0.45, 0.2>] [1 rgb <0.35, 0.2, 0.1>] } rotate <5, 20, 0> scale 0.6 } finish { ambient 1 diffuse 0 } }
