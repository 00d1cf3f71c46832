// A glass sphere turns the scene upside down.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
plane { z, 5 pigment { checker rgb 0.95, rgb <0.2, 0.3, 0.6> scale 1.3 } }
sphere { 0, 1.4 pigment { rgbf <0.95, 1, 0.95, 0.95> } finish { phong 0.8 } interior { ior 1.5 } }
