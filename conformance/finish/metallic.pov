// metallic highlights take the surface's colour.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
sphere { -1.3*x, 1.1 pigment { rgb <0.9, 0.6, 0.2> } finish { specular 1 roughness 0.05 } }
sphere { 1.3*x, 1.1 pigment { rgb <0.9, 0.6, 0.2> } finish { specular 1 roughness 0.05 metallic } }
