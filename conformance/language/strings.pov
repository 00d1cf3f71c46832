// The length and the letters of a string place spheres.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
#declare S = concat("ray", strupr("gio"), str(7, -3, 1));
#for (I, 1, strlen(S))
    sphere { <I - 5, (asc(substr(S, I, 1)) - 80)/20, 0>, 0.4 pigment { rgb <I/9, 0.5, 1 - I/9> } }
#end
