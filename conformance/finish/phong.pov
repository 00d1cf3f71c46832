// phong highlights of several sizes.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
sphere { -2*x, 0.9 pigment { rgb <0.2, 0.4, 0.7> } finish { phong 0.8 phong_size 5 } }
sphere { 0*x, 0.9 pigment { rgb <0.2, 0.4, 0.7> } finish { phong 1 phong_size 40 } }
sphere { 2*x, 0.9 pigment { rgb <0.2, 0.4, 0.7> } finish { phong 1 phong_size 200 } }
