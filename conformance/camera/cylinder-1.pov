// Cylindrical camera of kind 1.
#version 3.7;
global_settings { assumed_gamma 1 }
light_source { <3, 5, -6>, rgb 1 }
camera { cylinder 1 location <0, 1, -1.6> look_at <0, 0.4, 0> angle 170 }
plane { y, 0 pigment { checker rgb <0.9, 0.9, 0.8>, rgb <0.3, 0.4, 0.5> } }
sphere { <-1, 0.7, 0>, 0.7 pigment { rgb <0.9, 0.3, 0.2> } }
box { <0.4, 0, -0.4>, <1.4, 1.4, 0.6> pigment { rgb <0.2, 0.6, 0.3> } }
cone { <0, 0, 2>, 0.6, <0, 2, 2>, 0 pigment { rgb <0.2, 0.4, 0.9> } }
background { rgb <0.6, 0.75, 0.9> }
