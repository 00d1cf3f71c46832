// How time grows with the number of objects: N spheres in a cube, smaller the more there are, so that they always
// cover as much of the picture. `raggio render --declare N=100000 --timing`
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (N) #declare N = 1000; #end
#declare Stream = seed(1);
#declare Radius = 0.3*pow(N, -1/3);
union {
    #for (I, 1, N)
        sphere { <rand(Stream), rand(Stream), rand(Stream)> - 0.5, Radius }
    #end
    pigment { rgb <0.7, 0.6, 0.4> }
}
camera { location <0.3, 0.4, -2> look_at 0 angle 35 }
light_source { <3, 4, -5>, rgb 1 }
