// Bezier prisms with a hole.
#include "stage.inc"
#declare K = 0.55;
#declare Ring = prism {
  linear_sweep bezier_spline -0.3, 0.3, 32
  #for (S, 0, 1)
    #local R = 1 - 0.5*S;
    <R, 0>, <R, R*K>, <R*K, R>, <0, R>
    <0, R>, <-R*K, R>, <-R, R*K>, <-R, 0>
    <-R, 0>, <-R, -R*K>, <-R*K, -R>, <0, -R>
    <0, -R>, <R*K, -R>, <R, -R*K>, <R, 0>
  #end
}
Crowd(Ring)
