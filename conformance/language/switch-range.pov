// #switch with cases, ranges, falling through and #else.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
#for (I, 0, 6)
    #switch (I)
        #case (0) #declare Tint = <1, 0, 0>; #break
        #range (1, 2) #declare Tint = <0, 1, 0>; #break
        #case (3)
        #case (4) #declare Tint = <0, 0, 1>; #break
        #else #declare Tint = <1, 1, 0>;
    #end
    sphere { x*(I - 3), 0.45 pigment { rgb Tint } }
#end
