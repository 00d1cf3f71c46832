// Light that comes out beside where it went in.
#version 3.7;
global_settings { assumed_gamma 1 subsurface { samples 40, 10 } mm_per_unit 10 }
camera { location <0, 0, -4> look_at 0 angle 35 }
light_source { <3, 5, -6>, rgb 1 }
sphere { 0, 0.9 pigment { rgb <0.8, 0.7, 0.5> } finish { subsurface { translucency <0.3, 0.2, 0.1> } } interior { ior 1.4 } }
plane { y, -0.9 pigment { rgb 0.6 } }
