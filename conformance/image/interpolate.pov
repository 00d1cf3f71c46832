// The four kinds of interpolation, enlarged.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z look_at 0 right 8*x up 6*y }
box { 0, <1, 1, 0.1> pigment { image_map { png "../data/colors.png"  } } finish { ambient 1 diffuse 0 } scale <4, 3, 1> translate <-4, 0, 0> }
box { 0, <1, 1, 0.1> pigment { image_map { png "../data/colors.png" interpolate 2 } } finish { ambient 1 diffuse 0 } scale <4, 3, 1> translate <0, 0, 0> }
box { 0, <1, 1, 0.1> pigment { image_map { png "../data/colors.png" interpolate 3 } } finish { ambient 1 diffuse 0 } scale <4, 3, 1> translate <-4, -3, 0> }
box { 0, <1, 1, 0.1> pigment { image_map { png "../data/colors.png" interpolate 4 } } finish { ambient 1 diffuse 0 } scale <4, 3, 1> translate <0, -3, 0> }
