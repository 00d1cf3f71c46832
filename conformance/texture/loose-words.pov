// Words of a pigment without its block, as before version 1.5: in any order, and marble and wood jump back where they end.
#version 1.0
camera { location <0, 0, -7> look_at <0, 0, 0> }
light_source { <2, 3, -5> color red 1 green 1 blue 1 }
sphere { <-2, 1.1, 0>, 1 texture { marble turbulence 0.4 } }
sphere { <0, 1.1, 0>, 1 texture { turbulence 0.3 wood scale 0.4 } }
sphere { <2, 1.1, 0>, 1
  texture { color_map { [0 0.5 color red 1 color blue 1] [0.5 1 color blue 1 color green 1] } marble ambient 0.3 }
}
sphere { <-2, -1.1, 0>, 1 texture { onion scale 0.3 phong 1 } }
sphere { <0, -1.1, 0>, 1 texture { checker color red 1 color blue 1 scale 0.4 bumps 0.4 } }
sphere { <2, -1.1, 0>, 1 texture { pigment { marble } } }
