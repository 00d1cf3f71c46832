// normal_map switches between normals.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
box { <-2, -1.3, -0.3>, <2, 1.3, 0.3> rotate -20*x pigment { rgb <0.7, 0.7, 0.75> } finish { phong 0.6 phong_size 30 } normal { gradient x normal_map { [0 bumps 0.8 scale 0.2] [0.5 wrinkles 0] [1 dents 1 scale 0.3] } scale 4 translate -2*x } }
