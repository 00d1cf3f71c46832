// The scene that is drawn when no other is named.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 2, -5> look_at <0, 0.8, 0> right x * image_width / image_height }
light_source { <-6, 8, -6> rgb 1 }
background { rgb <0.5, 0.7, 1.0> }
plane { y, 0 pigment { checker rgb 0.9, rgb 0.2 } }
sphere { <0, 1, 0>, 1 pigment { rgb <0.8, 0.2, 0.1> } finish { specular 0.6 reflection 0.2 } }
