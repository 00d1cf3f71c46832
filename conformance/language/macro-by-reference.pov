// A macro changes the variable that the caller passed by name, by #declare and by #local.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
#macro Grow(V) #declare V = V + 0.5; #end
#declare A = 0.5;
Grow(A)
#declare B = 0.5;
#macro Shrink(V) #local V = V - 0.3; #end
Shrink(B)
sphere { -x, A pigment { rgb <0.8, 0.3, 0.3> } }
sphere { x, B pigment { rgb <0.3, 0.3, 0.8> } }
