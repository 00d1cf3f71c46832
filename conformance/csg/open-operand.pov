// An open cylinder takes part with its inside.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
intersection { cylinder { -2*y, 2*y, 1 open } box { <-2, -1, -2>, <2, 1, 2> } rotate <-35, 0, 15> pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
