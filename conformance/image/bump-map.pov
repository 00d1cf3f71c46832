// Bump maps by colour and by index, with all kinds of interpolation.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -4> look_at 0 angle 35 }
light_source { <3, 5, -6>, rgb 1 }
sphere { <-1.1, 0.55, 0>, 0.52 pigment { rgb <0.8, 0.7, 0.6> } normal { bump_map { png "../data/dots.png" bump_size 4 } scale 0.5 translate 0.1 } finish { phong 0.5 } }
sphere { <0, 0.55, 0>, 0.52 pigment { rgb <0.8, 0.7, 0.6> } normal { bump_map { png "../data/colors.png" interpolate 2 bump_size 4 } scale 0.5 translate 0.1 } finish { phong 0.5 } }
sphere { <1.1, 0.55, 0>, 0.52 pigment { rgb <0.8, 0.7, 0.6> } normal { bump_map { png "../data/colors.png" use_color interpolate 3 bump_size 3 } scale 0.5 translate 0.1 } finish { phong 0.5 } }
sphere { <-1.1, -0.55, 0>, 0.52 pigment { rgb <0.8, 0.7, 0.6> } normal { bump_map { png "../data/palette.png" use_index bump_size 0.5 } scale 0.5 translate 0.1 } finish { phong 0.5 } }
sphere { <0, -0.55, 0>, 0.52 pigment { rgb <0.8, 0.7, 0.6> } normal { bump_map { png "../data/palette.png" use_index interpolate 2 bump_size 0.5 } scale 0.5 translate 0.1 } finish { phong 0.5 } }
sphere { <1.1, -0.55, 0>, 0.52 pigment { rgb <0.8, 0.7, 0.6> } normal { bump_map { png "../data/palette.png" use_color interpolate 4 once bump_size 4 } scale 0.5 translate 0.1 } finish { phong 0.5 } }
