// Quartics: a knot of two tori.
#include "stage.inc"
#declare Thing = quartic {
  <1, 0, 0, 0, 2, 0, 0, 2, 0, -2.245, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
   1, 0, 0, 2, 0, 1.755, 0, 0, 0, 0, 1, 0, -2.245, 0, 0.7600001>
  scale 0.7
  clipped_by { sphere { 0, 1.4 } }
}
Crowd(Thing)
