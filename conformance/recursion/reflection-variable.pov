// Reflection from a minimum to a maximum, with falloff.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.2 } }
sky_sphere { pigment { gradient y color_map { [0 rgb 1] [1 rgb <0.2, 0.4, 1>] } } }
sphere { -1.1*x, 1 pigment { rgb 0 } finish { reflection { 0, 1 falloff 3 } } }
sphere { 1.1*x, 1 pigment { rgb 0 } finish { reflection { rgb <0.2, 0.2, 0>, rgb <1, 0.8, 0.2> falloff 1 } } }
