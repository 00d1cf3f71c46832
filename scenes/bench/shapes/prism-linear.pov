// Linear prisms with 40 sides.
#include "stage.inc"
#declare Gear = prism {
  linear_sweep linear_spline -0.4, 0.4, 41
  #for (K, 0, 40) #local A = 2*pi*K/40; (mod(K, 2) ? 1 : 0.8)*<cos(A), sin(A)> #end
}
Crowd(Gear)
