// conserve_energy takes what is reflected from what passes.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
plane { z, 4 pigment { checker rgb 0.9, rgb 0.2 } }
sphere { -1.3*x, 1.1 pigment { rgbt <0.9, 0.9, 1, 0.7> } finish { reflection 0.5 } }
sphere { 1.3*x, 1.1 pigment { rgbt <0.9, 0.9, 1, 0.7> } finish { reflection 0.5 conserve_energy } }
