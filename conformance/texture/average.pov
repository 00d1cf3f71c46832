// The mean of textures, by weight.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -4> look_at 0 angle 35 }
light_source { <3, 5, -6>, rgb 1 }
sphere { 0, 1.1 texture { average texture_map { [1  pigment { rgb <0.9, 0.3, 0.2> } finish { phong 1 } ] [2  pigment { rgb <0.2, 0.5, 0.9> } normal { bumps 0.6 scale 0.05 } ] [0.5  pigment { rgb 0.9 } finish { reflection 0.3 } ] } } }
