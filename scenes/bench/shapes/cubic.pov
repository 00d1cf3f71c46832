// Cubics in a ball.
#include "stage.inc"
#declare Thing = intersection {
  cubic { <4, -3, -3, -1, -3, 2, -1, -3, -1, 0.5, 4, -3, -1, -3, -1, 0.5, 4, -1, 0.5, 0> }
  sphere { 0, 1.1 }
}
Crowd(Thing)
