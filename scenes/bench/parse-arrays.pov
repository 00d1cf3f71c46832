// Reading speed: arrays filled, sieved and sorted. The picture is of no interest.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Limit = 200000;
#declare Sieve = array[Limit + 1];
#for (I, 0, Limit) #declare Sieve[I] = 1; #end
#for (I, 2, sqrt(Limit))
    #if (Sieve[I])
        #for (J, I*I, Limit, I) #declare Sieve[J] = 0; #end
    #end
#end
#declare Primes = 0;
#for (I, 2, Limit) #declare Primes = Primes + Sieve[I]; #end
// Shell sort of vectors by their length.
#declare Count = 8000;
#declare Points = array[Count];
#declare Stream = seed(1);
#for (I, 0, Count - 1) #declare Points[I] = <rand(Stream), rand(Stream), rand(Stream)>; #end
#declare Gap = int(Count/2);
#while (Gap > 0)
    #for (I, Gap, Count - 1)
        #declare Held = Points[I];
        #declare J = I;
        #while (J >= Gap)
            #if (vlength(Points[J - Gap]) > vlength(Held))
                #declare Points[J] = Points[J - Gap];
                #declare J = J - Gap;
            #else
                #declare Points[J] = Held;
                #declare J = -1;
            #end
        #end
        #if (J >= 0) #declare Points[J] = Held; #end
    #end
    #declare Gap = int(Gap/2.2);
#end
#debug concat("primes ", str(Primes, 0, 0), " first ", str(vlength(Points[0]), 0, 6), "\n")
camera { location -3*z look_at 0 }
light_source { <2, 4, -3>, rgb 1 }
sphere { 0, 1 pigment { rgb <0.2, 0.5, 0.5> } }
