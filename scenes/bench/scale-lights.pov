// How time grows with the number of lights. `raggio render --declare N=16 --timing`
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (N) #declare N = 4; #end
#declare Stream = seed(1);
#for (I, 1, 300)
    sphere { <4*rand(Stream) - 2, 0.15, 4*rand(Stream) - 2>, 0.15 pigment { rgb <rand(Stream), 0.6, 0.4> } finish { phong 0.4 } }
#end
plane { y, 0 pigment { rgb 0.8 } }
camera { location <0, 3, -4> look_at 0 angle 45 }
#for (I, 1, N)
    light_source { <8*cos(2*pi*I/N), 4 + rand(Stream), 8*sin(2*pi*I/N)>, rgb 1/N }
#end
