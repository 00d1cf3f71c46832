// A #while loop makes a row of spheres.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
#declare I = -3;
#while (I <= 3)
    sphere { x*I, 0.45 pigment { rgb <0.5 + I/8, 0.4, 0.6> } }
    #declare I = I + 1;
#end
