// Infinite operands: planes and a quadric cut a sphere.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
difference { sphere { 0, 1.6 } plane { <1, 0.3, -1>, -0.6 } quadric { <1, 0, 1>, 0, 0, -0.3 } rotate <-20, 20, 0> pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
