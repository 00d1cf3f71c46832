// Discs with and without a hole.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
disc { -1.2*x, <0.3, 0.4, -1>, 1 pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
disc { 1.2*x, <-0.3, 0.4, -1>, 1, 0.5 pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
