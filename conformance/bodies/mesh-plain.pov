// A mesh of triangles over a floor that shows its shadow.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.3, -4> look_at 0 angle 45 }
light_source { <3, 5, -6>, rgb 1 }
mesh { triangle { <-0.9, -0.6, -0.5>, <0.9, -0.6, -0.5>, <0, 0.9, 0> } triangle { <0.9, -0.6, -0.5>, <0, -0.6, 0.9>, <0, 0.9, 0> } triangle { <0, -0.6, 0.9>, <-0.9, -0.6, -0.5>, <0, 0.9, 0> } triangle { <-0.9, -0.6, -0.5>, <0, -0.6, 0.9>, <0.9, -0.6, -0.5> } inside_vector <0.1, 1, 0.2> rotate <10, 25, 0> pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
plane { y, -1.1 pigment { rgb 0.8 } }
