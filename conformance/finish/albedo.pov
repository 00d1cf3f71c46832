// diffuse, phong and specular by albedo.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
sphere { -2*x, 0.9 pigment { rgb 0.7 } finish { diffuse albedo 0.6 brilliance 3 } }
sphere { 0*x, 0.9 pigment { rgb 0.7 } finish { phong albedo 0.2 phong_size 20 } }
sphere { 2*x, 0.9 pigment { rgb 0.7 } finish { specular albedo 0.2 roughness 0.03 } }
