// Before version 3.5 `orthographic` makes the frame that is there as large as it is at the point looked at; later words do not.
#version 3.1;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -8> direction 1.5*z angle 50 orthographic right 3*x look_at <0, 0, 0> }
light_source { <3, 5, -6>, rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.8, 0.6>, rgb <0.3, 0.4, 0.6> scale 0.5 } }
sphere { 0, 1 pigment { rgb <0.8, 0.3, 0.3> } finish { phong 1 } }
