// Reading speed: nested loops and arithmetic. The picture is of no interest.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Sum = 0;
#declare Row = 0;
#while (Row < 1000)
    #for (Column, 1, 500)
        #declare Sum = Sum + sin(Row*0.01)*cos(Column*0.02) + mod(Row*Column, 7)/7;
        #if (Sum > 1e6) #declare Sum = Sum - 1e6; #end
    #end
    #declare Row = Row + 1;
#end
#debug concat("sum ", str(Sum, 0, 6), "\n")
camera { location -3*z look_at 0 }
light_source { <2, 4, -3>, rgb 1 }
sphere { 0, 1 pigment { rgb <mod(Sum, 1), 0.5, 0.5> } }
