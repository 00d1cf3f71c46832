// Dispersion in a prism.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
plane { z, 5 pigment { gradient x color_map { [0.45 rgb 0] [0.45 rgb 1] [0.55 rgb 1] [0.55 rgb 0] } scale 2 } finish { ambient 1 diffuse 0 } }
box { <-1.5, -1, -0.5>, <1.5, 1, 0.5> rotate y*40 pigment { rgbf 1 } interior { ior 1.5 dispersion 1.1 dispersion_samples 7 } }
