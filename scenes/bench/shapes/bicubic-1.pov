// Bicubic patches of type 1.
#include "stage.inc"
#declare R = seed(5);
#macro P(I, J) <I - 1.5, 1.2*rand(R) - 0.6, J - 1.5> #end
#declare Sheet = bicubic_patch {
  type 1 flatness 0.01 u_steps 4 v_steps 4
  P(0,0) P(1,0) P(2,0) P(3,0) P(0,1) P(1,1) P(2,1) P(3,1)
  P(0,2) P(1,2) P(2,2) P(3,2) P(0,3) P(1,3) P(2,3) P(3,3)
  scale 0.8
}
Crowd(Sheet)
