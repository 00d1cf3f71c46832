// Text along a circle, lying and turned up.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "shapes.inc"
camera { orthographic location <2, 3, -10> look_at 0 right 8 * x up 6 * y }
light_source { <3, 6, -9> rgb 1 }
#macro Around(Inverted, Valign)
    object { Circle_Text_Valigned("../data/strokes.ttf", "I H L IT", 0.9, 0.05, 0.3, 1.2, Inverted, Align_Left, 100, Valign) pigment { rgb <0.9, 0.7, 0.5> } }
#end
object { Around(0, 0) translate <-2.2, 1.3, 0> }
object { Around(0, -90) translate <2.2, 1.3, 0> }
object { Around(1, -60) translate <-2.2, -1.4, 0> }
object { Circle_Text("../data/strokes.ttf", "L IT H", 0.9, 0.05, 0.3, 1.2, 0, Align_Center, 90) translate <2.2, -1.4, 0> pigment { rgb <0.9, 0.7, 0.5> } }
