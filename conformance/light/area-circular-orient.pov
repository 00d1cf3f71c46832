// A circular area light that turns to what it lights.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <2, 4, -3>, rgb 1 area_light 2*x, 2*y, 7, 7 circular orient }
plane { y, -1 pigment { rgb 0.8 } }
plane { z, 3 pigment { rgb <0.7, 0.7, 0.8> } }
sphere { <-1, -0.2, 0>, 0.8 pigment { rgb <0.9, 0.4, 0.3> } finish { phong 0.7 } }
box { <0.5, -1, -0.5>, <1.5, 0.6, 0.5> pigment { rgb <0.4, 0.7, 0.5> } }
