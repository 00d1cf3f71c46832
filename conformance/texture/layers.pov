// Layered textures show through each other.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
sphere { 0, 1.5
    texture { pigment { checker rgb <0.9, 0.7, 0.3>, rgb <0.4, 0.2, 0.1> scale 0.5 } }
    texture { pigment { gradient y color_map { [0.4 rgbt <1, 1, 1, 1>] [0.6 rgbt <0.2, 0.3, 0.9, 0.2>] } scale 0.7 } finish { phong 1 } }
}
