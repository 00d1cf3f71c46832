// A sky sphere of two pigments.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
sky_sphere { pigment { gradient y color_map { [0 rgb <1, 0.8, 0.6>] [0.5 rgb <0.2, 0.4, 0.9>] } scale 2 translate -y } pigment { bozo turbulence 0.6 color_map { [0.4 rgbt 1] [0.7 rgbt <1, 1, 1, 0.2>] } scale <0.6, 0.2, 0.6> } }
plane { y, -1 pigment { rgb <0.3, 0.5, 0.2> } }
