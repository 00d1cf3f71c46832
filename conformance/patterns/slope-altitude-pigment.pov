// Slope mixed with altitude, and slope towards a point.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -4> look_at 0 angle 35 }
light_source { <3, 5, -6>, rgb 1 }
sphere { <0.45, 0, 0>, 0.75 pigment { slope { <0.3, 1, -0.5>, 0.1, 0.9 altitude <0.2, 1, 0>, -0.5, 0.8 } color_map { [0 rgb <0.1, 0.1, 0.4>] [0.4 rgb <0.9, 0.3, 0.2>] [0.7 rgb <0.95, 0.9, 0.4>] [1 rgb <0.2, 0.7, 0.5>] } } }
box { <-1.2, -0.8, 0>, <-0.2, 0.8, 1> rotate <0, 25, 0> pigment { slope { point_at <3, 2, -1>, 0.3, 0.9 } color_map { [0 rgb <0.1, 0.1, 0.4>] [0.4 rgb <0.9, 0.3, 0.2>] [0.7 rgb <0.95, 0.9, 0.4>] [1 rgb <0.2, 0.7, 0.5>] } } }
