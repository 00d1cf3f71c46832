// #for with a negative step, and the value that is left after the loop.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
#for (I, 3, -3, -1.5)
    box { <I - 0.4, -0.4, -0.4>, <I + 0.4, 0.4, 0.4> pigment { rgb <0.2, 0.5, 0.8> } }
#end
sphere { <0, I/3, 0>, 0.3 pigment { rgb <1, 0.5, 0> } }
