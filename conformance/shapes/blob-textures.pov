// Components of a blob blend their textures.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
blob {
    threshold 0.4
    sphere { <-0.8, 0, 0>, 1.5, 1 pigment { rgb <1, 0.2, 0.2> } }
    sphere { <0.8, 0, 0>, 1.5, 1 pigment { rgb <0.2, 0.4, 1> } }
}
