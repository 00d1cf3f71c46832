// How far the four points of a pattern normal lie apart.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -4> look_at 0 angle 35 }
light_source { <3, 5, -6>, rgb 1 }
sphere { <-1.1, 0.55, 0>, 0.52 pigment { rgb <0.8, 0.7, 0.6> } normal { granite 0.5  scale 0.6 } finish { phong 0.5 } }
sphere { <0, 0.55, 0>, 0.52 pigment { rgb <0.8, 0.7, 0.6> } normal { granite 0.5 accuracy 0.001 scale 0.6 } finish { phong 0.5 } }
sphere { <1.1, 0.55, 0>, 0.52 pigment { rgb <0.8, 0.7, 0.6> } normal { granite 0.5 accuracy 0.02 scale 0.6 } finish { phong 0.5 } }
sphere { <-1.1, -0.55, 0>, 0.52 pigment { rgb <0.8, 0.7, 0.6> } normal { granite 0.5 accuracy 0.1 scale 0.6 } finish { phong 0.5 } }
sphere { <0, -0.55, 0>, 0.52 pigment { rgb <0.8, 0.7, 0.6> } normal { granite 0.5 accuracy 0.5 scale 0.6 } finish { phong 0.5 } }
sphere { <1.1, -0.55, 0>, 0.52 pigment { rgb <0.8, 0.7, 0.6> } normal { granite 0.5 slope_map { [0 <0, 1>] [0.5 <1, 0>] [1 <0, -1>] } accuracy 0.05 scale 0.6 } finish { phong 0.5 } }
