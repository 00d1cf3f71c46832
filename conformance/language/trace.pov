// trace() sets spheres on a torus, where it says the surface is.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
#declare Ring = torus { 1.4, 0.6 rotate -50*x }
object { Ring pigment { rgb <0.5, 0.6, 0.7> } }
#for (I, -5, 5)
    #declare N = <0, 0, 0>;
    #declare P = trace(Ring, <I*0.4, 0.8, -5>, z, N);
    #if (vlength(N) > 0) cone { P, 0.15, P + 0.5*N, 0 pigment { rgb <1, 0.3, 0> } } #end
#end
