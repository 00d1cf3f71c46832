// Conic prisms of cubic outlines.
#include "stage.inc"
#declare Flower = prism {
  conic_sweep cubic_spline 0.1, 1, 19
  #for (K, -1, 17) #local A = 2*pi*mod(K + 16, 16)/16; (mod(K + 16, 2) ? 1.1 : 0.6)*<cos(A), sin(A)> #end
  translate -0.5*y
}
Crowd(Flower)
