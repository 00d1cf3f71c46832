// Light from behind through a thin sheet.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 angle 50 }
light_source { <2, 3, 5>, rgb 1 }
disc { -1.2*x, <0.3, 0, -1>, 1 pigment { rgb <0.9, 0.8, 0.5> } finish { diffuse 0.6, 0.4 } }
disc { 1.2*x, <-0.3, 0, -1>, 1 pigment { rgb <0.9, 0.8, 0.5> } finish { diffuse 0.6 } }
