// woods.inc: every finished wood.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "woods.inc"
camera { orthographic location -10*z direction z right 8*x up 6*y }
light_source { <-30, 30, -60>, rgb 1 }
background { rgb <0.3, 0.5, 0.2> }
#declare Place = -1;
#macro Next(T)
    #declare Place = Place + 1;
    sphere { 0, 0.48 texture { T scale 0.6 } translate <mod(Place, 8) - 3.5, 2.5 - floor(Place/8), 0> }
#end
Next(T_Wood1) Next(T_Wood2) Next(T_Wood3) Next(T_Wood4) Next(T_Wood5) Next(T_Wood6) Next(T_Wood7) Next(T_Wood8)
Next(T_Wood9) Next(T_Wood10) Next(T_Wood11) Next(T_Wood12) Next(T_Wood13) Next(T_Wood14) Next(T_Wood15)
Next(T_Wood16) Next(T_Wood17) Next(T_Wood18) Next(T_Wood19) Next(T_Wood20) Next(T_Wood21) Next(T_Wood22)
Next(T_Wood23) Next(T_Wood24) Next(T_Wood25) Next(T_Wood26) Next(T_Wood27) Next(T_Wood28) Next(T_Wood29)
Next(T_Wood30) Next(T_Wood31) Next(T_Wood32) Next(T_Wood33) Next(T_Wood34) Next(T_Wood35)
