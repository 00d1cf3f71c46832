// The teapot between two mirrors, for recursion depths 0 to 7.
//
// With max_trace_level 1 the mirrors are black; each level more adds one image of the teapot behind them, fainter
// by the mirror's reflection of 85 percent and seen alternately from both sides. Declare=Depth=n sets the level.
#version 3.7;

#ifndef (Depth) #declare Depth = 7; #end

global_settings { assumed_gamma 1 max_trace_level max(1, Depth) adc_bailout 0.002 }
#include "teapot.inc"

camera { location <5.2, 4.6, -8.4> look_at <-0.4, 1.2, 0.6> right x*image_width/image_height angle 46 }
light_source { <6, 10, -7>, rgb 1 }
light_source { <-3, 7, -4>, rgb 0.25 shadowless }
background { rgb <0.35, 0.45, 0.55> }

object {
    Teapot
    rotate y*20
    pigment { rgb <0.9, 0.35, 0.2> }
    finish { ambient 0.1 diffuse 0.65 specular 0.6 roughness 0.02 reflection 0.06 }
}
plane { y, 0 pigment { checker rgb <0.9, 0.88, 0.82>, rgb <0.45, 0.5, 0.55> } finish { diffuse 0.7 } }

// Two mirrors in frames, at an angle to each other.
#declare Mirror = union {
    box { <-5, 0.15, 0>, <5, 5, 0.05> pigment { rgb 0.02 } finish { ambient 0 diffuse 0.1 reflection 0.85 } }
    box { <-5.15, 0, 0.02>, <5.15, 5.15, 0.2> pigment { rgb <0.3, 0.2, 0.12> } }
}
object { Mirror translate z*4.2 }
object { Mirror rotate -y*75 translate <-5, 0, -0.5> }
