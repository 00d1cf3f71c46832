// Cubic prisms.
#include "stage.inc"
#declare Flower = prism {
  linear_sweep cubic_spline -0.4, 0.4, 19
  #for (K, -1, 17) #local A = 2*pi*mod(K + 16, 16)/16; (mod(K + 16, 2) ? 1.1 : 0.6)*<cos(A), sin(A)> #end
}
Crowd(Flower)
