// `caustics` in a finish is a power, `caustics` in an interior a 45th of one.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -7> look_at 0 angle 45 }
light_source { <6, 9, -6>, rgb 1 }
plane { y, -1 pigment { rgb 0.7 } }
sphere { -1.2*x, 1 pigment { rgbf <0.9, 0.8, 1, 0.8> } finish { refraction 1 ior 1.5 caustics 0.6 } }
sphere { 1.2*x, 1 pigment { rgbf <0.9, 0.8, 1, 0.8> } interior { ior 1.5 caustics 0.6 } }
