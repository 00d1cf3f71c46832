// texture_map blends whole textures.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
sphere { 0, 1.5 texture { gradient x texture_map { [0.3 pigment { rgb <0.9, 0.2, 0.2> } finish { phong 1 }] [0.7 pigment { checker rgb 1, rgb 0.2 scale 0.3 }] } scale 3 translate -1.5*x } }
