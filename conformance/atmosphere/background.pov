// A background and no objects in the way.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
background { rgb <0.3, 0.5, 0.8> }
sphere { 0, 1 pigment { rgb <0.9, 0.7, 0.2> } }
