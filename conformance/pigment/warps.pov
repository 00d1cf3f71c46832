// warp repeat with flip, black hole and a turbulence warp.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z look_at 0 right 8*x up 6*y }
box { <-4, -3, 0>, <-1.3, 3, 1> pigment { gradient <1, 2, 0> color_map { [0 rgb <1, 0, 0>] [1 rgb <1, 1, 0>] } warp { repeat x flip x } warp { repeat 1.5*y offset 0.3*x } scale 0.8 } finish { ambient 1 diffuse 0 } }
box { <-1.3, -3, 0>, <1.3, 3, 1> pigment { checker rgb 0, rgb <0.8, 0.9, 1> scale 0.4 translate 0.1*z warp { black_hole <0, 0, 0>, 1.2 falloff 2 strength 0.9 } } finish { ambient 1 diffuse 0 } }
box { <1.3, -3, 0>, <4, 3, 1> pigment { checker rgb <0.2, 0.5, 0.2>, rgb 1 scale 0.6 translate 0.1*z warp { turbulence 0.3 octaves 4 } } finish { ambient 1 diffuse 0 } }
