// A thin film colours what is mirrored too.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at 0 }
light_source { <3, 8, -5> rgb 0.5 }
background { rgb <0.6, 0.7, 0.8> }
sphere { 0, 1.4 pigment { rgb 0.1 } finish { diffuse 0.3 reflection 0.6 irid { 0.5 thickness 0.6 } } }
plane { y, -1.4 pigment { rgb 0.4 } finish { reflection 0.5 irid { 0.4 thickness 0.4 } } normal { bumps 0.2 } }
