// A single number fills a vector; a shorter vector is filled with zeros.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
sphere { 0, 0.6 scale 1.5 translate -2*x pigment { rgb 0.7 } }
sphere { <1, 1>*0.5 + z, 0.6 pigment { rgb <0.2, 0.8> } }
box { -0.4, 0.4 translate <2, -1> pigment { rgb <0, 0.5, 1>*0.8 } }
