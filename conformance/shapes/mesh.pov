// A mesh of flat and smooth triangles with a texture of its own.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
#declare Red = texture { pigment { rgb <0.9, 0.2, 0.2> } }
mesh {
    triangle { <-2, -1, 0>, <0, -1, -0.5>, <-1, 1, 0> }
    triangle { <0, -1, -0.5>, <1, 1, 0>, <-1, 1, 0> texture { Red } }
    smooth_triangle { <0, -1, -0.5>, <-0.5, 0, -1>, <2, -1, 0>, <1, 0, -1>, <1, 1, 0>, <0, 1, -1> }
    pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 }
}
