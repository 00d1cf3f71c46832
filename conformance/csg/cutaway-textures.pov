// cutaway_textures gives the cut the texture of what is cut.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
difference {
    union { sphere { -0.5*x, 1 pigment { rgb <1, 0.3, 0.2> } } sphere { 0.5*x, 1 pigment { rgb <0.2, 0.4, 1> } } }
    box { <-3, -3, -3>, <3, 3, -0.2> }
    cutaway_textures rotate y*20
}
