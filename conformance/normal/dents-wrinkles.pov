// dents and wrinkles.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
sphere { -1.3*x, 1.1 pigment { rgb <0.7, 0.7, 0.75> } finish { phong 0.6 phong_size 30 } normal { dents 0.8 scale 0.3 } }
sphere { 1.3*x, 1.1 pigment { rgb <0.7, 0.7, 0.75> } finish { phong 0.6 phong_size 30 } normal { wrinkles 0.8 scale 0.3 } }
