// Differences: dice with pips and a bore.
#include "stage.inc"
#declare Die = difference {
  intersection { box { -0.8, 0.8 } sphere { 0, 1.1 } }
  cylinder { -z, z, 0.3 }
  #for (I, -1, 1, 2)
    #for (J, -1, 1, 2)
      sphere { <0.4*I, 0.85, 0.4*J>, 0.2 }
      sphere { <0.85, 0.4*I, 0.4*J>, 0.2 }
      sphere { <-0.85, 0.4*I, 0.4*J>, 0.2 }
    #end
  #end
}
Crowd(Die)
