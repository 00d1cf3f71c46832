// Commas between numbers may be left out.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 45 }
light_source { <3, 5, -6> rgb 1 }
sphere { <-1 0 0> 0.8 pigment { mandel 20 exterior 2 1.5 interior 1 2 color_map { [0 rgb 0.1][1 rgb 1] } translate <-0.3 0 0> } finish { diffuse 0.7 0.3 } }
disc { <1 0 0> <0.2 0.3 -1> 0.9 0.4 pigment { rgb <0.9 0.4 0.2> } finish { diffuse 0.2 0.8 } }
cone { <0 -1 0> 0.4 <0 -0.2 0> 0.1 pigment { rgb <0.2 0.4 0.9> } }
