// material joins texture and interior.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
plane { z, 4 pigment { checker rgb 0.95, rgb 0.3 } }
#declare Glass = material { texture { pigment { rgbf <0.8, 1, 0.9, 0.9> } finish { phong 1 } } interior { ior 1.4 } }
sphere { -1.2*x, 1 material { Glass } }
box { -0.8, 0.8 rotate <20, 30, 0> translate 1.3*x material { Glass } }
