// Faked caustics under a glass ball.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <2, 5, -3>, rgb 1 }
plane { y, -1.2 pigment { rgb 0.8 } }
sphere { 0, 1 pigment { rgbf <0.9, 1, 0.9, 0.9> } interior { ior 1.5 caustics 1 } }
