// Old syntax: `declare` at version 3.0 without semicolons, `color red`, `[a b color X color Y]`.
#version 3.0
#declare Tint = color red 0.9 green 0.5 blue 0.2
camera { location <0, 0, -5> look_at <0, 0, 0> }
light_source { <3, 5, -6> color red 1 green 1 blue 1 }
sphere { <0, 0, 0>, 1.3
    pigment { gradient y color_map { [0.0 0.5 color Tint color red 1] [0.5 1.0 color green 1 color Tint] } }
}
