// Lathes of quadratic splines.
#include "stage.inc"
#declare Vase = lathe {
  quadratic_spline 9
  <0.3, -1.1>, <0.5, -1>, <0.2, -0.8>, <0.8, -0.3>, <0.6, 0.2>, <0.3, 0.5>, <0.35, 0.8>, <0.6, 1>, <0.7, 1.1>
}
Crowd(Vase)
