// `uv_mapping` before an identifier holds for what the identifier brings.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -4> look_at 0 }
light_source { <4, 5, -5> rgb 1 }
#declare Spots = pigment { bozo scale 0.15 color_map { [0.4 rgb <1, 0.8, 0.3>] [0.5 rgb <0.2, 0.4, 0.9>] } }
#declare Dents = normal { dents 2 scale 0.1 }
#declare Sheet = mesh2 {
  vertex_vectors { 4, <-1, -1, 0>, <1, -1, 0>, <1, 1, 0.5>, <-1, 1, 0> }
  uv_vectors { 4, <0, 0>, <1, 0>, <1, 1>, <0, 1> }
  face_indices { 2, <0, 1, 2>, <0, 2, 3> }
}
object { Sheet texture { pigment { uv_mapping Spots scale 0.8 } } translate -1.1*x }
object { Sheet texture { pigment { rgb 1 } normal { uv_mapping Dents scale 0.5 } finish { phong 0.5 } } translate 1.1*x }
