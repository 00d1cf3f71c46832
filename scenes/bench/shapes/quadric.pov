// Quadrics: hyperboloids between two planes.
#include "stage.inc"
#declare Thing = intersection {
  quadric { <1, -0.6, 1>, 0, 0, -0.15 }
  plane { y, 1 }
  plane { -y, 1 }
}
Crowd(Thing)
