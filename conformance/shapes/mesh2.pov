// mesh2 with normals, uv vectors and textures for the faces.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
mesh2 {
    vertex_vectors { 5, <-1.5, -1, 0>, <1.5, -1, 0>, <1.5, 1, 0.5>, <-1.5, 1, 0.5>, <0, 0, -1> }
    normal_vectors { 5, <-1, -1, -1>, <1, -1, -1>, <1, 1, -1>, <-1, 1, -1>, <0, 0, -1> }
    texture_list { 2, texture { pigment { rgb <0.9, 0.6, 0.2> } } texture { pigment { rgb <0.2, 0.6, 0.9> } } }
    face_indices { 4, <0, 1, 4>, 0, <1, 2, 4>, 1, <2, 3, 4>, 0, <3, 0, 4>, 0, 1, 1 }
}
