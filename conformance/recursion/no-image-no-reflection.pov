// no_image hides from the camera, no_reflection from mirrors.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
plane { z, 2.5 pigment { rgb 0.1 } finish { reflection 0.8 } }
sphere { <-1.3, 0, 0>, 0.7 pigment { rgb <1, 0.3, 0.2> } no_image }
sphere { <1.3, 0, 0>, 0.7 pigment { rgb <0.2, 0.5, 1> } no_reflection }
