// A box given by two opposite corners in any order.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
box { <1, -1, 1>, <-1, 1, -1> rotate <20, 35, 10> pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
