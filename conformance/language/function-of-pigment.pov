// A pigment as a function: its colours drive heights.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
#declare F = function { pigment { gradient x color_map { [0 rgb <0, 0.2, 0>] [0.5 rgb <1, 0.5, 0>] [1 rgb <0, 0, 0.9>] } scale 4 } }
#for (X, 0, 3.9, 0.3)
    cylinder { <X - 2, -1.5, 0>, <X - 2, -1.5 + 2*F(X, 0, 0).red + 0.1, 0>, 0.13 pigment { rgb F(X, 0, 0) } }
#end
