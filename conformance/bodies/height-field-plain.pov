// A height field over a floor that shows its shadow.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.3, -4> look_at 0 angle 45 }
light_source { <3, 5, -6>, rgb 1 }
height_field { function 24, 24 { 0.5 + 0.4*sin(9*x)*cos(7*y) } smooth translate <-0.5, 0, -0.5> scale <1.7, 0.6, 1.7> translate -0.3*y rotate <-30, 25, 0> pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
plane { y, -1.1 pigment { rgb 0.8 } }
