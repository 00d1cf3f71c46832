// Polynomials of degree 6 in a ball.
#include "stage.inc"
#declare Thing = intersection {
  polynomial {
    6,
    xyz(6,0,0): 1, xyz(0,6,0): 1, xyz(0,0,6): 1, xyz(2,2,2): -20, xyz(4,2,0): 1.5, xyz(0,4,2): 1.5,
    xyz(2,0,4): 1.5, xyz(1,1,1): 0.4, xyz(2,0,0): 0.1, xyz(0,0,0): -0.25
  }
  sphere { 0, 1.2 }
}
Crowd(Thing)
