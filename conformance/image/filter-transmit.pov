// Transparency of all pixels, of colours by index, and from alpha.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z look_at 0 right 8*x up 6*y }
plane { -z, -1 pigment { checker rgb <0.2, 0.3, 0.9>, rgb <1, 0.9, 0.3> scale 0.5 } finish { ambient 1 diffuse 0 } }
box { 0, <1, 1, 0.1> pigment { image_map { png "../data/colors.png" filter all 0.6 } } finish { ambient 1 diffuse 0 } scale <4, 2, 1> translate <-4, 1, 0> }
box { 0, <1, 1, 0.1> pigment { image_map { png "../data/colors.png" transmit all 0.6 } } finish { ambient 1 diffuse 0 } scale <4, 2, 1> translate <0, 1, 0> }
box { 0, <1, 1, 0.1> pigment { image_map { png "../data/palette.png" filter 1, 0.8 transmit 2, 0.7 } } finish { ambient 1 diffuse 0 } scale <4, 2, 1> translate <-4, -1, 0> }
box { 0, <1, 1, 0.1> pigment { image_map { png "../data/palette.png" filter all 0.4 transmit 3, 0.9 interpolate 2 } } finish { ambient 1 diffuse 0 } scale <4, 2, 1> translate <0, -1, 0> }
box { 0, <1, 1, 0.1> pigment { image_map { png "../data/clear.png"  } } finish { ambient 1 diffuse 0 } scale <4, 2, 1> translate <-4, -3, 0> }
box { 0, <1, 1, 0.1> pigment { image_map { png "../data/clear.png" interpolate 2 transmit all 0.2 } } finish { ambient 1 diffuse 0 } scale <4, 2, 1> translate <0, -3, 0> }
