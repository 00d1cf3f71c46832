// Merges of glass.
#include "stage.inc"
#declare Jack = merge {
  sphere { 0, 0.4 }
  #for (K, 0, 2)
    #local A = vrotate(x, K*90*z + (K = 2 ? 90*y : 0));
    cylinder { -A, A, 0.15 }
    sphere { A, 0.25 }
    sphere { -A, 0.25 }
  #end
  texture { pigment { rgbt <1, 1, 1, 0.9> } finish { phong 1 reflection 0.1 } }
  interior { ior 1.3 }
}
Crowd(Jack)
