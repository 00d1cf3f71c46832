// Object as a pigment.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -4> look_at 0 angle 35 }
light_source { <3, 5, -6>, rgb 1 }
sphere { <0.45, 0, 0>, 0.75 pigment { object { torus { 0.7, 0.3 rotate 90*x } rgb <0.2, 0.3, 0.6>, rgb <0.9, 0.3, 0.2> } } }
box { <-1.2, -0.8, 0>, <-0.2, 0.8, 1> rotate <0, 25, 0> pigment { object { torus { 0.7, 0.3 rotate 90*x } rgb <0.2, 0.3, 0.6>, rgb <0.9, 0.3, 0.2> } } }
