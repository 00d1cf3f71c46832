// A Bezier patch over a floor that shows its shadow.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.3, -4> look_at 0 angle 45 }
light_source { <3, 5, -6>, rgb 1 }
bicubic_patch { type 1 flatness 0.001 u_steps 4 v_steps 4 <-1.5, -1.5, 0>, <-0.5, -1.5, -1>, <0.5, -1.5, 1>, <1.5, -1.5, 0>, <-1.5, -0.5, -1>, <-0.5, -0.5, -2>, <0.5, -0.5, 0>, <1.5, -0.5, -1>, <-1.5, 0.5, 1>, <-0.5, 0.5, 0>, <0.5, 0.5, 2>, <1.5, 0.5, 1>, <-1.5, 1.5, 0>, <-0.5, 1.5, -1>, <0.5, 1.5, 1>, <1.5, 1.5, 0> scale 0.55 rotate <20, 30, 0> pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
plane { y, -1.1 pigment { rgb 0.8 } }
