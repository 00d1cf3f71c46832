// checker of textures, tiles.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
plane { y, -1 texture { checker texture { pigment { rgb <0.9, 0.4, 0.2> } finish { reflection 0.3 } } texture { pigment { rgb 0.9 } normal { bumps 0.5 scale 0.1 } } } }
sphere { 0.3*y, 0.9 pigment { rgb <0.3, 0.6, 0.9> } }
