// A pattern and a function as normals, with accuracy.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
sphere { -1.3*x, 1.1 pigment { rgb <0.7, 0.7, 0.75> } finish { phong 0.6 phong_size 30 } normal { granite 0.3 accuracy 0.01 scale 0.8 } }
sphere { 1.3*x, 1.1 pigment { rgb <0.7, 0.7, 0.75> } finish { phong 0.6 phong_size 30 } normal { function { sin(x*12)*sin(y*12) } 0.5 } }
