// Discs with holes.
#include "stage.inc"
Crowd(disc { 0, y, 1.1, 0.4 })
