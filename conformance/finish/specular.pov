// specular highlights of several roughnesses.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
sphere { -2*x, 0.9 pigment { rgb <0.2, 0.5, 0.3> } finish { specular 0.8 roughness 0.2 } }
sphere { 0*x, 0.9 pigment { rgb <0.2, 0.5, 0.3> } finish { specular 0.8 roughness 0.05 } }
sphere { 2*x, 0.9 pigment { rgb <0.2, 0.5, 0.3> } finish { specular 1 roughness 0.002 } }
