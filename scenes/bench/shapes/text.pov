// Text.
#include "stage.inc"
#declare Word = text { ttf "timrom.ttf" "Raggio rays" 0.3, 0 scale 0.7 translate <-1.4, -0.2, 0> }
Crowd(Word)
#declare Line = text { ttf "cyrvetic.ttf" "The quick brown fox jumps over the lazy dog" 0.2, 0 }
#for (K, 0, 9) object { Line rotate 60*x scale 0.75 translate <-7.5, 0.2, 1.1*K - 5> pigment { rgb <0.8, 0.4, 0.3> } } #end
