// `tiles` is a checker that begins with its second texture.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0.3, 5, -4> look_at 0 }
light_source { <3, 8, -5> rgb 1 }
plane {
    y, 0.25
    texture {
        tiles {
            texture { pigment { rgb <1, 0.3, 0.2> } }
            tile2
            texture { pigment { rgb <0.2, 0.3, 1> } }
        }
    }
}
