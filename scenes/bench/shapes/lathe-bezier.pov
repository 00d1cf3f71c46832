// Lathes of Bezier splines.
#include "stage.inc"
#declare Vase = lathe {
  bezier_spline 12
  <0.1, -1>, <0.7, -1>, <0.2, -0.6>, <0.7, -0.4>
  <0.7, -0.4>, <1.2, -0.2>, <0.5, 0.2>, <0.4, 0.4>
  <0.4, 0.4>, <0.3, 0.6>, <0.6, 0.8>, <0.7, 1>
}
Crowd(Vase)
