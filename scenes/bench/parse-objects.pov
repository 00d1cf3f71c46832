// Reading speed: many objects, textures and transformations made in loops. The picture is of no interest.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Stream = seed(7);
#declare Plain = texture { pigment { rgb <0.6, 0.7, 0.8> } finish { phong 0.5 } }
#declare Part = union {
    cylinder { -y, y, 0.2 }
    sphere { y, 0.3 }
    texture { Plain }
}
union {
    #for (I, 1, 120000)
        #local At = <rand(Stream), rand(Stream), rand(Stream)> - <0.5, 0.5, 0.5>;
        #if (mod(I, 3) = 0)
            object { Part scale 0.01 rotate <360*rand(Stream), 360*rand(Stream), 0> translate At }
        #else
            sphere { At, 0.004 + 0.004*rand(Stream) pigment { rgb At + <0.5, 0.5, 0.5> } }
        #end
    #end
}
camera { location -2*z look_at 0 }
light_source { <2, 4, -3>, rgb 1 }
