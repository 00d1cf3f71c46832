// Operations in operations.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
difference {
    intersection { sphere { 0, 1.5 } box { -1.2, 1.2 } }
    union { cylinder { -2*x, 2*x, 0.6 } cylinder { -2*y, 2*y, 0.6 } cylinder { -2*z, 2*z, 0.6 } }
    rotate <25, 35, 0> pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 }
}
