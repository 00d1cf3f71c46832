// quilted with controls, and facets.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
box { -0.9, 0.9 rotate <20, 30, 0> translate -1.4*x pigment { rgb <0.7, 0.7, 0.75> } finish { phong 0.6 phong_size 30 } normal { quilted 1 control0 0.3 control1 0.8 scale 0.5 } }
sphere { 1.3*x, 1.1 pigment { rgb <0.7, 0.7, 0.75> } finish { phong 0.6 phong_size 30 } normal { facets coords 0.3 size 0.4 } }
