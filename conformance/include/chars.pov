// chars.inc and logo.inc.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "chars.inc"
#include "logo.inc"
camera { orthographic location -30*z direction z right 32*x up 24*y }
light_source { <-100, 100, -300>, rgb 1 }
#declare Place = -1;
#macro Next(O)
    #declare Place = Place + 1;
    object { O pigment { rgb <0.3, 0.9, 0.6> } rotate <20, 30, 0> translate <5.2*mod(Place, 6) - 13, 6 - 6*floor(Place/6), 0> }
#end
Next(char_A) Next(char_B) Next(char_G) Next(char_K) Next(char_Q) Next(char_R)
Next(char_S) Next(char_Z) Next(char_2) Next(char_6) Next(char_AtSign) Next(char_Amps)
Next(char_ExclPt) Next(char_Hat) Next(object { Povray_Logo scale 3 translate 2*y })
Next(object { Povray_Logo_Prism scale 3 translate 2*y }) Next(object { Povray_Logo_Bevel scale 3 translate 2*y }) Next(char_9)
