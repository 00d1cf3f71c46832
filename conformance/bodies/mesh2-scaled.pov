// An indexed mesh with normals, a thousand times smaller and a thousand times larger, each as far away as its size asks for.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location 0 look_at z angle 45 }
light_source { <30000, 50000, -60000>, rgb 1 }
#declare Thing = mesh2 { vertex_vectors { 6, <1, 0, 0>, <-1, 0, 0>, <0, 1, 0>, <0, -1, 0>, <0, 0, 1>, <0, 0, -1> } normal_vectors { 6, <1, 0, 0>, <-1, 0, 0>, <0, 1, 0>, <0, -1, 0>, <0, 0, 1>, <0, 0, -1> } face_indices { 8, <0, 2, 4>, <2, 1, 4>, <1, 3, 4>, <3, 0, 4>, <2, 0, 5>, <1, 2, 5>, <3, 1, 5>, <0, 3, 5> } inside_vector <0.2, 1, 0.1> rotate <15, 25, 0> pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
object { Thing scale <1, 0.8, 1.1> rotate 20*z translate <-1, 0.2, 4> scale 0.001 }
object { Thing scale <1, 0.8, 1.1> rotate 20*z translate <1, -0.2, 4> scale 1000 }
