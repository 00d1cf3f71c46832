// Pictures as patterns: of brightness, alpha and indices.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z look_at 0 right 8*x up 6*y }
box { 0, <1, 1, 0.1> pigment { image_pattern { png "../data/colors.png"  } color_map { [0 rgb <0.1, 0.1, 0.4>] [0.4 rgb <0.9, 0.3, 0.2>] [0.7 rgb <0.95, 0.9, 0.4>] [1 rgb <0.2, 0.7, 0.5>] } } finish { ambient 1 diffuse 0 } scale <4, 2, 1> translate <-4, 1, 0> }
box { 0, <1, 1, 0.1> pigment { image_pattern { png "../data/colors.png" interpolate 2 } color_map { [0 rgb <0.1, 0.1, 0.4>] [0.4 rgb <0.9, 0.3, 0.2>] [0.7 rgb <0.95, 0.9, 0.4>] [1 rgb <0.2, 0.7, 0.5>] } } finish { ambient 1 diffuse 0 } scale <4, 2, 1> translate <0, 1, 0> }
box { 0, <1, 1, 0.1> pigment { image_pattern { png "../data/clear.png" use_alpha interpolate 2 } color_map { [0 rgb <0.1, 0.1, 0.4>] [0.4 rgb <0.9, 0.3, 0.2>] [0.7 rgb <0.95, 0.9, 0.4>] [1 rgb <0.2, 0.7, 0.5>] } } finish { ambient 1 diffuse 0 } scale <4, 2, 1> translate <-4, -1, 0> }
box { 0, <1, 1, 0.1> pigment { image_pattern { png "../data/palette.png" use_index } color_map { [0 rgb <0.1, 0.1, 0.4>] [0.4 rgb <0.9, 0.3, 0.2>] [0.7 rgb <0.95, 0.9, 0.4>] [1 rgb <0.2, 0.7, 0.5>] } } finish { ambient 1 diffuse 0 } scale <4, 2, 1> translate <0, -1, 0> }
box { 0, <1, 1, 0.1> pigment { image_pattern { png "../data/palette.png" use_color } color_map { [0 rgb <0.1, 0.1, 0.4>] [0.4 rgb <0.9, 0.3, 0.2>] [0.7 rgb <0.95, 0.9, 0.4>] [1 rgb <0.2, 0.7, 0.5>] } } finish { ambient 1 diffuse 0 } scale <4, 2, 1> translate <-4, -3, 0> }
box { 0, <1, 1, 0.1> pigment { image_pattern { png "../data/colors.png" once interpolate 4 } color_map { [0 rgb <0.1, 0.1, 0.4>] [0.4 rgb <0.9, 0.3, 0.2>] [0.7 rgb <0.95, 0.9, 0.4>] [1 rgb <0.2, 0.7, 0.5>] } } finish { ambient 1 diffuse 0 } scale <4, 2, 1> translate <0, -3, 0> }
