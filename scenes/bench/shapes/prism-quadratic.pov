// Quadratic prisms.
#include "stage.inc"
#declare Wave = prism {
  linear_sweep quadratic_spline -0.4, 0.4, 18
  #for (K, -1, 16) #local A = 2*pi*mod(K + 16, 16)/16; (mod(K + 16, 2) ? 1 : 0.7)*<cos(A), sin(A)> #end
}
Crowd(Wave)
