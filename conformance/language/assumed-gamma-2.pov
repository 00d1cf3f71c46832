// assumed_gamma 2.2.
#version 3.7;
global_settings { assumed_gamma 2.2 }
camera { location -5*z look_at 0 angle 50 }
light_source { <3, 5, -6>, rgb 1 }
background { rgb 0.5 }
sphere { 0, 1.5 pigment { rgb <0.5, 0.25, 0.75> } finish { ambient 0.2 } }
