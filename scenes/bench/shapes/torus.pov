// Tori.
#include "stage.inc"
Crowd(torus { 0.8, 0.3 })
