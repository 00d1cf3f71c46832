// How time grows with the depth of recursion: two mirrors face to face with things between them.
// `raggio render --declare N=16 --timing`
#version 3.7;
#ifndef (N) #declare N = 5; #end
global_settings { assumed_gamma 1 max_trace_level N adc_bailout 0 }
#declare Mirror = texture { pigment { rgb 0.1 } finish { ambient 0 diffuse 0.1 reflection 0.95 } }
plane { z, 3 texture { Mirror } }
plane { z, -3.5 texture { Mirror } }
#declare Stream = seed(1);
#for (I, 1, 60)
    sphere { <4*rand(Stream) - 2, 3*rand(Stream) - 1.5, 4*rand(Stream) - 2>, 0.12 pigment { rgb <rand(Stream), 0.6, 0.4> } }
#end
camera { location <0.2, 0.1, -3> look_at z angle 60 }
light_source { <2, 4, -2>, rgb 1 }
