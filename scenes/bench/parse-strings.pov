// Reading speed: numbers to text, text cut, joined and compared. The picture is of no interest.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Hits = 0;
#declare Letters = 0;
#for (I, 1, 180000)
    #declare Word = concat("item-", str(I, -6, 0), "-", vstr(3, <I, I/2, I/3>, ",", 0, 2));
    #if (strcmp(substr(Word, 6, 3), "012") = 0) #declare Hits = Hits + 1; #end
    #declare Letters = Letters + strlen(strupr(Word)) + asc(substr(Word, 1 + mod(I, 5), 1)) + val(substr(Word, 6, 6));
#end
#debug concat("hits ", str(Hits, 0, 0), " letters ", str(Letters, 0, 0), "\n")
camera { location -3*z look_at 0 }
light_source { <2, 4, -3>, rgb 1 }
sphere { 0, 1 pigment { rgb <0.2, 0.5, 0.5> } }
