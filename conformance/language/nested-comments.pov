// Comments nest, and quotes in them mean nothing.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
/* outer /* inner " */ still a comment */
sphere { 0, 1.4 pigment { rgb <0.4, 0.8, 0.4> } } // "
