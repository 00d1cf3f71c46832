// A blob of spheres and a cylinder, one of them negative.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
blob {
    threshold 0.5
    sphere { <-1, 0, 0>, 1.2, 1 }
    sphere { <0.8, 0.4, 0>, 1.4, 1 }
    cylinder { <-1, -1, 0>, <1, -1, 0>, 0.6, 1.5 }
    sphere { <0.5, 0.4, -1>, 0.8, -1 }
    pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 }
}
