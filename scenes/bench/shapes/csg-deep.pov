// CSG nested eight deep.
#include "stage.inc"
#macro Nest(D, S)
  #if (D = 0) sphere { 0, S }
  #else
    #if (mod(D, 2))
      difference { union { Nest(D - 1, S) box { -S*0.6, S*0.6 translate 0.3*S*y } } cylinder { -2*S*x, 2*S*x, 0.2*S rotate D*33*y } }
    #else
      intersection { object { Nest(D - 1, S) scale 1.05 } merge { sphere { 0.1*D*x, S } box { -S*0.8, S*0.8 rotate D*20*z } } }
    #end
  #end
#end
#declare Thing = object { Nest(8, 0.9) }
Crowd(Thing)
