// A texture follows the transformations that come after it, not those before.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
box { -0.8, 0.8 rotate z*30 pigment { gradient x color_map { [0 rgb <1, 0, 0>] [1 rgb 1] } scale 0.4 } translate -1.5*x }
box { -0.8, 0.8 pigment { gradient x color_map { [0 rgb <1, 0, 0>] [1 rgb 1] } scale 0.4 } rotate z*30 translate 1.5*x }
