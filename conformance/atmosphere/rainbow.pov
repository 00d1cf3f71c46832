// A rainbow against the sky.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
background { rgb <0.4, 0.5, 0.7> }
rainbow { angle 18 width 6 distance 1000 direction z up y color_map { [0 rgbt <0.5, 0, 1, 0.6>] [0.5 rgbt <0, 1, 0.3, 0.6>] [1 rgbt <1, 0.1, 0, 0.6>] } }
plane { y, -1 pigment { rgb <0.3, 0.5, 0.2> } }
