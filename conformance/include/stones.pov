// stones.inc: every finished stone.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "colors.inc"
#include "stones.inc"
camera { orthographic location -10*z direction z right 8*x up 6*y }
light_source { <-30, 30, -60>, rgb 1 }
background { rgb <0.3, 0.5, 0.2> }
#declare Place = -1;
#macro Next(T)
    #declare Place = Place + 1;
    sphere { 0, 0.48 texture { T scale 0.6 } translate <mod(Place, 8) - 3.5, 2.5 - floor(Place/8), 0> }
#end
Next(T_Stone1) Next(T_Stone2) Next(T_Stone3) Next(T_Stone4) Next(T_Stone5) Next(T_Stone6) Next(T_Stone7)
Next(T_Stone8) Next(T_Stone9) Next(T_Stone10) Next(T_Stone11) Next(T_Stone12) Next(T_Stone13) Next(T_Stone14)
Next(T_Stone15) Next(T_Stone16) Next(T_Stone17) Next(T_Stone18) Next(T_Stone19) Next(T_Stone20) Next(T_Stone21)
Next(T_Stone22) Next(T_Stone23) Next(T_Stone24) Next(T_Stone25) Next(T_Stone26) Next(T_Stone27) Next(T_Stone28)
Next(T_Stone29) Next(T_Stone30) Next(T_Stone31) Next(T_Stone32) Next(T_Stone33) Next(T_Stone34) Next(T_Stone35)
Next(T_Stone36) Next(T_Stone37) Next(T_Stone38) Next(T_Stone39) Next(T_Stone40) Next(T_Stone41) Next(T_Stone42)
Next(T_Stone43) Next(T_Stone44) Next(T_Grnt0) Next(T_Grnt9) Next(T_Grnt15) Next(T_Grnt29)
