// Where no member of a cutaway difference has a texture, all get the default one.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2, 3, -5> look_at 0 angle 40 }
light_source { <3, 8, -5> rgb 1 }
#default { pigment { checker rgb <1, 0.5, 0.2> rgb 1 scale 0.3 } }
difference {
    box { -1, 1 }
    sphere { <0.3, 1, -0.5>, 0.9 }
    cutaway_textures
}
