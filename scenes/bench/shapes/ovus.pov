// Eggs.
#include "stage.inc"
Crowd(ovus { 0.7, 0.5 translate -0.3*y })
