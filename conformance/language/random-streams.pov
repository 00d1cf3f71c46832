// Two streams of random numbers are independent; the same seed repeats.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
#declare A = seed(12); #declare B = seed(12); #declare D = seed(99);
#for (I, 0, 24)
    sphere { <rand(A)*6 - 3, rand(A)*4 - 2, 0>, 0.25 pigment { rgb <rand(D), rand(D), rand(D)> } }
    box { -0.1, 0.1 translate <rand(B)*6 - 3, rand(B)*4 - 2, -0.4> pigment { rgb 1 } }
#end
