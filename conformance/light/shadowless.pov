// A shadowless light adds no highlights and no shadows.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 4, -4>, rgb 0.7 shadowless }
light_source { <-3, 4, -4>, rgb 0.4 }
plane { y, -1 pigment { rgb 0.8 } }
plane { z, 3 pigment { rgb <0.7, 0.7, 0.8> } }
sphere { <-1, -0.2, 0>, 0.8 pigment { rgb <0.9, 0.4, 0.3> } finish { phong 0.7 } }
box { <0.5, -1, -0.5>, <1.5, 0.6, 0.5> pigment { rgb <0.4, 0.7, 0.5> } }
