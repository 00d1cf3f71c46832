// One blob of 4000 components.
#include "stage.inc"
#declare R = seed(3);
blob {
  threshold 0.4
  #for (K, 1, 4000)
    #local A = K*2.399963;
    #local H = 1 - 2*(K - 0.5)/4000;
    #local W = sqrt(1 - H*H);
    sphere { (1.6 + 0.9*rand(R))*<W*cos(A), H, W*sin(A)>, 0.22 + 0.1*rand(R), 1 }
  #end
  scale 2.2
  translate -1.5*y
  pigment { rgb <0.8, 0.5, 0.4> } finish { phong 0.6 }
}
