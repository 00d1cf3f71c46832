// A picture several times in a unit, and moved.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z look_at 0 right 8*x up 6*y }
box { 0, <1, 1, 0.1> pigment { image_map { png "../data/colors.png" repeat <2, 3> } } finish { ambient 1 diffuse 0 } scale <4, 3, 1> translate <-4, 0, 0> }
box { 0, <1, 1, 0.1> pigment { image_map { png "../data/colors.png" offset <0.3, 0.4> } } finish { ambient 1 diffuse 0 } scale <4, 3, 1> translate <0, 0, 0> }
box { 0, <1, 1, 0.1> pigment { image_map { png "../data/colors.png" repeat <1.5, 2.5> offset <0.2, 0.1> interpolate 2 } } finish { ambient 1 diffuse 0 } scale <4, 3, 1> translate <-4, -3, 0> }
box { 0, <1, 1, 0.1> pigment { image_map { png "../data/colors.png" once offset <0.3, 0.4> } } finish { ambient 1 diffuse 0 } scale <4, 3, 1> translate <0, -3, 0> }
