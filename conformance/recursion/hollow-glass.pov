// A hollow shell of glass.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
plane { z, 5 pigment { checker rgb 0.95, rgb <0.5, 0.2, 0.2> } }
difference { sphere { 0, 1.4 } sphere { 0, 1.2 } pigment { rgbf 0.95 } finish { reflection 0.1 } interior { ior 1.5 } }
