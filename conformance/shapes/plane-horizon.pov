// Planes meet at the horizon.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.2, 0.4, 0.7> } }
plane { <1, 0.2, 0>, -3 pigment { rgb <0.7, 0.5, 0.3> } }
background { rgb <0.5, 0.7, 1> }
