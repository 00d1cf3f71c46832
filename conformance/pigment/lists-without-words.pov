// Lists of colours need none of their words.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -4> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
#declare Grey = 0.4;
box { <-1.9, -1, 0>, <-0.7, 1, 1> pigment { checker 1, Grey scale 0.4 } }
box { <-0.6, -1, 0>, <0.6, 1, 1> pigment { brick <0.9, 0.3, 0.2> 2*Grey brick_size 0.5 mortar 0.1 } }
box { <0.7, -1, 0>, <1.9, 1, 1> pigment { hexagon x y*0.5, rgb 1 rotate 90*x scale 0.2 } }
