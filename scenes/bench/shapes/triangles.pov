// Single triangles.
#include "stage.inc"
#declare R = seed(11);
#declare Burr = union {
  #for (K, 1, 300)
    #local P = vnormalize(<rand(R), rand(R), rand(R)> - 0.5);
    #local Q = vnormalize(<rand(R), rand(R), rand(R)> - 0.5);
    triangle { P*1.2, 0.2*Q, 0.2*vcross(P, Q) }
  #end
}
Crowd(Burr)
