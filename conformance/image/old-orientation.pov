// Very old scenes put a map type and a vector before the file.
#version 1.0;
camera { location <0 0 -4> direction <0 0 1> up <0 1 0> right <1.33 0 0> }
object { light_source { <3 5 -6> color red 1 green 1 blue 1 } }
object { sphere { <-1 0 0> 0.9 } texture { image_map { 5 <6.3 1 0> png "../data/colors.png" } scale <0.5 0.5 0.5> } }
object { sphere { <1 0 0> 0.9 } texture { image_map { <1 -1 0> png "../data/colors.png" } scale <0.5 0.5 0.5> } }
