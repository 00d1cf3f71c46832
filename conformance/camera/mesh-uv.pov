// A mesh camera by texture places, with smooth normals.
#version 3.7;
global_settings { assumed_gamma 1 }
camera {
    mesh_camera {
        1 3
        mesh {
            smooth_triangle {
                <-2, -1.5, 0>, <-0.3, -0.2, 1>, <-2, 1.5, 0>, <-0.3, 0.2, 1>, <2, 1.5, 0>, <0.3, 0.2, 1>
                uv_vectors <0, 0>, <0, 1>, <1, 1>
            }
            smooth_triangle {
                <-2, -1.5, 0>, <-0.3, -0.2, 1>, <2, 1.5, 0>, <0.3, 0.2, 1>, <2, -1.5, 0>, <0.3, -0.2, 1>
                uv_vectors <0, 0>, <1, 1>, <1, 0>
            }
        }
        smooth
    }
    location <0, 0, 0.01>
}
light_source { <3, 8, -5> rgb 1 }
sphere { 3 * z, 1 pigment { rgb <1, 0.4, 0.2> } }
plane { z, 8 pigment { checker rgb 0.2 rgb 0.8 } }
