// Materials chosen by index and by red.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z look_at 0 right 8*x up 6*y }
light_source { <3, 5, -10>, rgb 1 }
box { 0, <3.6, 2.6, 0.1> texture { material_map { png "../data/palette.png"  texture { pigment { rgb <0.9, 0.3, 0.2> } finish { phong 1 } } texture { pigment { checker rgb 0.2, rgb 0.9 scale 0.1 } } texture { pigment { rgb <0.2, 0.5, 0.9> } finish { ambient 0.5 } } } scale <1.8, 1.3, 1> } translate <-3.8, 0.2, 0> }
box { 0, <3.6, 2.6, 0.1> texture { material_map { png "../data/colors.png"  texture { pigment { rgb <0.9, 0.3, 0.2> } finish { phong 1 } } texture { pigment { checker rgb 0.2, rgb 0.9 scale 0.1 } } texture { pigment { rgb <0.2, 0.5, 0.9> } finish { ambient 0.5 } } } scale <1.8, 1.3, 1> } translate <0.2, 0.2, 0> }
box { 0, <3.6, 2.6, 0.1> texture { material_map { png "../data/palette.png" once texture { pigment { rgb <0.9, 0.3, 0.2> } finish { phong 1 } } texture { pigment { checker rgb 0.2, rgb 0.9 scale 0.1 } } texture { pigment { rgb <0.2, 0.5, 0.9> } finish { ambient 0.5 } } } scale <1.8, 1.3, 1> } translate <-3.8, -2.8, 0> }
box { 0, <3.6, 2.6, 0.1> texture { material_map { png "../data/palette.png" interpolate 2 texture { pigment { rgb <0.9, 0.3, 0.2> } finish { phong 1 } } texture { pigment { checker rgb 0.2, rgb 0.9 scale 0.1 } } texture { pigment { rgb <0.2, 0.5, 0.9> } finish { ambient 0.5 } } } scale <1.8, 1.3, 1> } translate <0.2, -2.8, 0> }
