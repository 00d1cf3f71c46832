// Intersections of spheres, cylinders, cones and planes.
#include "stage.inc"
#declare Gem = intersection {
  sphere { 0, 1 }
  cylinder { -y, y, 0.8 }
  cone { -1.2*x, 1.1, 1.2*x, 0.3 }
  #for (K, 0, 7) plane { vrotate(<1, 0.4, 0>, K*45*y), 0.75 } #end
}
Crowd(Gem)
