// A macro's result is text: R(3)*2 is 3*2 + 1*2.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
#macro R(A) A*2+1 #end
#declare V = R(3)*2;
sphere { 0, V/8 pigment { rgb <0.8, 0.3, 0.3> } }
sphere { x*2, 2*R(3)/20 pigment { rgb <0.3, 0.8, 0.3> } }
