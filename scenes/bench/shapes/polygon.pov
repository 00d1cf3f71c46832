// Polygons with 60 corners.
#include "stage.inc"
#declare Star = polygon {
  61
  #for (K, 0, 60) #local A = 2*pi*mod(K, 60)/60; (mod(K, 2) ? 1.1 : 0.6)*<cos(A), sin(A)> #end
}
Crowd(Star)
