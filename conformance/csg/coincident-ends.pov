// Where the end of a subtracted cone lies in the surface of what it cuts: an open one leaves no skin, a closed one does.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -7> look_at <0, 0.4, 0> }
light_source { <-4, 9, -6> rgb 1 }
#declare Cup = difference {
  cone { 0, 0.8, y, 1 pigment { rgb <1, 0.5, 0> } }
  cone { 0, 0.6, y, 0.8 open pigment { rgb <0.6, 0.8, 1> } }
}
#declare Ring = difference {
  cylinder { 0, y, 1 pigment { rgb <0.3, 0.8, 0.2> } }
  cylinder { 0, y, 0.7 open pigment { rgb <0.8, 0.3, 0.9> } }
}
object { Cup translate <-2.2, 0, 0> }
object { Ring }
difference {
  box { <-1, 0, -1>, <1, 1, 1> pigment { rgb <0.7, 0.7, 0.2> } }
  cylinder { 0, y, 0.7 open pigment { rgb <0.2, 0.3, 0.9> } }
  translate <2.4, 0, 0>
}
plane { y, -1 pigment { rgb 0.6 } }
