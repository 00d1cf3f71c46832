// Fresnel reflection.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.2 } }
sky_sphere { pigment { gradient y color_map { [0 rgb 1] [1 rgb <0.2, 0.4, 1>] } } }
sphere { 0, 1.3 pigment { rgb <0.1, 0, 0> } finish { reflection { 0, 1 fresnel on } } interior { ior 1.8 } }
