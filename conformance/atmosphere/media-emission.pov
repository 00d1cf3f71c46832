// Emitting media in a sphere.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
sphere { 0, 1.5 hollow pigment { rgbt 1 } interior { media { emission 0.8 density { spherical scale 1.5 color_map { [0 rgb 0] [0.6 rgb <1, 0.3, 0>] [1 rgb <1, 1, 0.5>] } } } } }
