// An egg with parts taken away.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.3, -4> look_at 0 angle 45 }
light_source { <3, 5, -6>, rgb 1 }
difference {
    ovus { 0.7, 0.35 translate -0.4*y rotate <-20, 0, 25> pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
    sphere { <0.5, 0.5, -0.7>, 0.75 pigment { rgb <0.3, 0.5, 0.8> } }
    box { <-2, -2, -2>, <-0.35, -0.2, 2> pigment { rgb <0.3, 0.7, 0.4> } }
}
