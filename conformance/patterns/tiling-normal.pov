// A tiling as a normal.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -4> look_at 0 angle 35 }
light_source { <3, 5, -6>, rgb 1 }
sphere { <0.45, 0, 0>, 0.75 pigment { rgb <0.7, 0.6, 0.5> } normal { tiling 8 0.6 rotate 90*x scale 0.25 } finish { phong 0.5 }  }
box { <-1.2, -0.8, 0>, <-0.2, 0.8, 1> rotate <0, 25, 0> pigment { rgb <0.7, 0.6, 0.5> } normal { tiling 8 0.6 rotate 90*x scale 0.25 } finish { phong 0.5 } }
