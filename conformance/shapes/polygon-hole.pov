// A polygon with a hole in it.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
polygon { 9, <-2, -1.5>, <2, -1.5>, <2, 1.5>, <-2, 1.5>, <-2, -1.5>, <-1, -0.5>, <1, -0.5>, <0, 1>, <-1, -0.5> rotate y*20 pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
