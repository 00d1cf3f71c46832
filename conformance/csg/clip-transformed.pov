// Transforms inside clipped_by and bounded_by move all objects of the block.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 45 }
light_source { <3, 5, -6>, rgb 1 }
#declare Tube = cylinder { -2*z, 2*z, 1 }
sphere { -0.9*x, 0.9 clipped_by { Tube scale 0.5 translate <-0.7, 0.2, 0> } pigment { rgb <0.9, 0.6, 0.2> } }
sphere { 0.9*x, 0.9 clipped_by { Tube object { Tube translate 0.5*y } scale 0.7 rotate 20*y translate 1.1*x } bounded_by { sphere { 0, 1 } translate 0.9*x } pigment { rgb <0.3, 0.6, 0.8> } }
