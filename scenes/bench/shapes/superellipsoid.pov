// Superellipsoids: a cushion, a star and a rod.
#include "stage.inc"
#declare Kinds = array[3] { <0.25, 0.4>, <1.5, 2>, <1, 0.1> }
#for (K, 0, 2)
  object { union { Crowd(superellipsoid { Kinds[K] scale 0.6 }) } translate <0.5*K - 0.5, 0.5*K, 0.6*K> }
#end
