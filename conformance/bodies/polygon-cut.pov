// A polygon with a hole cut by solids.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.3, -4> look_at 0 angle 45 }
light_source { <3, 5, -6>, rgb 1 }
intersection {
    polygon { 10, <-0.9, -0.8>, <0.9, -0.8>, <0.6, 0.8>, <-0.7, 0.7>, <-0.9, -0.8>, <-0.3, -0.3>, <0.3, -0.3>, <0.2, 0.3>, <-0.2, 0.3>, <-0.3, -0.3> rotate <20, 30, 0> pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
    union { sphere { <0.5, 0.3, 0>, 0.7 } box { <-2, -0.5, -2>, <-0.1, 0.3, 2> } }
    pigment { rgb <0.3, 0.5, 0.8> }
}
object { polygon { 10, <-0.9, -0.8>, <0.9, -0.8>, <0.6, 0.8>, <-0.7, 0.7>, <-0.9, -0.8>, <-0.3, -0.3>, <0.3, -0.3>, <0.2, 0.3>, <-0.2, 0.3>, <-0.3, -0.3> rotate <20, 30, 0> pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } } clipped_by { plane { y, -0.6 } } }
