// fade_distance, fade_power and fade_color in glass.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
plane { z, 5 pigment { checker rgb 0.95, rgb 0.4 } }
sphere { -1.3*x, 1.1 pigment { rgbf 1 } interior { ior 1.2 fade_distance 0.6 fade_power 2 fade_color rgb <0.9, 0.3, 0.1> } }
sphere { 1.3*x, 1.1 pigment { rgbf 1 } interior { ior 1.2 fade_distance 0.6 fade_power 1001 fade_color rgb <0.1, 0.4, 0.9> } }
