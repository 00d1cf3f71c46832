// Lenses, bowls and half boxes of glass: small CSG of convex members.
#include "stage.inc"
#declare Lens = intersection { sphere { -0.8*y, 1.2 } sphere { 0.8*y, 1.2 } }
#declare Bowl = difference { sphere { 0, 1 } sphere { 0, 0.9 } plane { -y, 0 } }
#declare Half = difference { box { -0.8, 0.8 } plane { <1, 1, 0.3>, 0 } }
#declare Glass = texture { pigment { rgbt <0.9, 1, 1, 0.85> } finish { phong 1 reflection 0.1 } }
#macro Clear(O) object { O texture { Glass } interior { ior 1.5 } } #end
union { Crowd(Clear(Lens)) translate -1.2*z }
union { Crowd(Clear(Bowl)) scale 0.6 translate <0.6, 1, 1.5> }
union { Crowd(Clear(Half)) scale 0.5 translate <-0.8, 1.2, -3> }
