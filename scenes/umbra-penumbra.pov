// Umbra and penumbra: the same ball and rod under a point light (left) and under a square light (right).
//
// A point is in the umbra where no part of the light is seen, in the penumbra where some of it is. The light's
// width over the distance of the shadow caster gives the penumbra's: the rod's shadow is sharp at its foot and
// blurred at its tip. Each shadow of the right half averages 17 x 17 shadow rays.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 7.5, -9.5> look_at <0, 0.4, 0.5> right x*image_width/image_height angle 40 }
background { rgb 0.02 }

#declare Still = union {
    sphere { <0, 1, 0>, 0.7 pigment { rgb <0.9, 0.45, 0.25> } }
    cylinder { <-1.1, 0, 0.9>, <-1.1, 2.4, 0.9>, 0.07 pigment { rgb <0.3, 0.6, 0.9> } }
    box { <-2.3, -0.1, -2.2>, <2.3, 0, 3.2> pigment { rgb 0.85 } }
}

// A wall between the halves keeps each light to its own side.
box { <-0.05, -0.1, -2.2>, <0.05, 4.2, 3.2> pigment { rgb 0.3 } no_image }

light_group {
    light_source { <-4.4, 5, -1.6>, rgb 1 }
    object { Still translate -2.5*x }
    global_lights off
}
light_group {
    light_source { <0.6, 5, -1.6>, rgb 1 area_light 1.6*x, 1.6*z, 17, 17 }
    object { Still translate 2.5*x }
    global_lights off
}
