// A height field of 600 by 600 samples.
#include "stage.inc"
height_field {
  function 600, 600 { pattern { bumps turbulence 0.5 scale 0.15 } }
  smooth
  translate <-0.5, 0, -0.5>
  scale <24, 5, 24>
  pigment { rgb <0.6, 0.7, 0.4> }
}
