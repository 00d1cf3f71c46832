// Reading speed: macro calls, arguments by value and by reference, and recursion. The picture is of no interest.
#version 3.7;
global_settings { assumed_gamma 1 }
#macro Mix(A, B, T) (A*(1 - T) + B*T) #end
#macro Step(State)
    #local Next = mod(State*16807, 2147483647);
    #declare State = Next;
    (Next/2147483647)
#end
#macro Tree(Depth, Start, Length)
    #if (Depth = 0)
        #declare Leaves = Leaves + 1;
    #else
        Tree(Depth - 1, Start + Length*x, Length*0.7)
        Tree(Depth - 1, Start + Length*y, Length*0.7)
    #end
#end
#declare State = 42;
#declare Total = 0;
#for (I, 1, 100000)
    #declare Total = Total + Mix(Step(State), I/100000, 0.25);
#end
#declare Leaves = 0;
Tree(16, <0, 0, 0>, 1)
#debug concat("total ", str(Total, 0, 6), " leaves ", str(Leaves, 0, 0), "\n")
camera { location -3*z look_at 0 }
light_source { <2, 4, -3>, rgb 1 }
sphere { 0, 1 pigment { rgb <mod(Total, 1), 0.5, 0.5> } }
