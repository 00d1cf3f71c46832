// An indexed mesh with normals inside a ball of glass.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.3, -4> look_at 0 angle 45 }
light_source { <3, 5, -6>, rgb 1 }
mesh2 { vertex_vectors { 6, <1, 0, 0>, <-1, 0, 0>, <0, 1, 0>, <0, -1, 0>, <0, 0, 1>, <0, 0, -1> } normal_vectors { 6, <1, 0, 0>, <-1, 0, 0>, <0, 1, 0>, <0, -1, 0>, <0, 0, 1>, <0, 0, -1> } face_indices { 8, <0, 2, 4>, <2, 1, 4>, <1, 3, 4>, <3, 0, 4>, <2, 0, 5>, <1, 2, 5>, <3, 1, 5>, <0, 3, 5> } inside_vector <0.2, 1, 0.1> rotate <15, 25, 0> pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
sphere { 0, 1.25 pigment { rgbf <0.95, 1, 0.97, 0.9> } finish { specular 0.6 reflection 0.08 } interior { ior 1.35 } }
plane { y, -1.4 pigment { checker rgb 0.9 rgb 0.6 } }
