// How time grows with the number of copies of one mesh. `raggio render --declare N=100000 --timing`
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (N) #declare N = 1000; #end
#declare Stream = seed(1);
#declare Knot = function(u, v) { 1 + 0.35*cos(v) }
#declare Steps = 48;
#declare Ring = mesh {
    #for (I, 0, Steps - 1)
        #for (K, 0, Steps - 1)
            #local U0 = 2*pi*I/Steps; #local U1 = 2*pi*(I + 1)/Steps;
            #local V0 = 2*pi*K/Steps; #local V1 = 2*pi*(K + 1)/Steps;
            #local A = <Knot(U0, V0)*cos(U0), 0.35*sin(V0), Knot(U0, V0)*sin(U0)>;
            #local B = <Knot(U1, V0)*cos(U1), 0.35*sin(V0), Knot(U1, V0)*sin(U1)>;
            #local C = <Knot(U1, V1)*cos(U1), 0.35*sin(V1), Knot(U1, V1)*sin(U1)>;
            #local D = <Knot(U0, V1)*cos(U0), 0.35*sin(V1), Knot(U0, V1)*sin(U0)>;
            triangle { A, B, C } triangle { A, C, D }
        #end
    #end
}
union {
    #for (I, 1, N)
        object { Ring scale 0.25*pow(N, -1/3) rotate <360*rand(Stream), 360*rand(Stream), 0> translate <rand(Stream), rand(Stream), rand(Stream)> - 0.5 }
    #end
    pigment { rgb <0.7, 0.6, 0.4> }
}
camera { location <0.3, 0.4, -2> look_at 0 angle 35 }
light_source { <3, 4, -5>, rgb 1 }
