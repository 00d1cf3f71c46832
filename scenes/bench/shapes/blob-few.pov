// Blobs of five components each.
#include "stage.inc"
#declare Drop = blob {
  threshold 0.5
  sphere { <0.5, 0, 0>, 0.9, 1 }
  sphere { <-0.5, 0.2, 0.1>, 0.8, 1 }
  sphere { <0, 0.6, -0.2>, 0.7, 1 }
  cylinder { <0, -0.8, 0>, <0, 0.4, 0.4>, 0.5, 1 }
  sphere { <0, 0, -0.7>, 0.5, -0.8 }
}
Crowd(Drop)
