// Sphere sweeps: cubic_spline.
#include "stage.inc"
#declare Coil = sphere_sweep {
  cubic_spline 22
  #for (K, 0, 21) #local A = K*0.75; <0.8*cos(A), K*0.1 - 1, 0.8*sin(A)>, 0.12 + 0.05*sin(K) #end
}
Crowd(Coil)
