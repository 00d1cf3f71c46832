// Objects moved to infinity, or to nowhere, are never hit; they neither cut nor fail.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -7> look_at 0 }
light_source { <2, 8, -5> rgb 1 }
#declare Infinite = 1/0;
#declare Undefined = pow(-1, 0.5);
sphere { 0, 1 pigment { rgb <1, 0, 0> } translate Infinite*x }
sphere { Undefined, 1 pigment { rgb <1, 1, 0> } }
cylinder { Undefined*y, y, 1 pigment { rgb <1, 0, 1> } }
difference {
  sphere { 0, 1 }
  sphere { 0, 1 translate Infinite }
  pigment { rgb <0, 0.6, 1> } translate -1.5*x
}
union {
  box { -0.7, 0.7 }
  sphere { <1, Undefined, 1>, 2 }
  pigment { rgb <0, 1, 0.5> } translate 1.5*x
}
intersection {
  sphere { 0, 2 }
  sphere { 0, 2 translate Infinite }
  pigment { rgb 1 }
}
