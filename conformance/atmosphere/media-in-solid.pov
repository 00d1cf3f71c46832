// No media where the camera stands in a solid: behind a plane that is not hollow.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
plane { z, 4 pigment { checker rgb 0.95, rgb 0.6 } }
box { -1, 1 rotate y*30 hollow pigment { rgbt 1 } interior { media { absorption <0.2, 0.6, 0.9> } } }
