// A prism of glass that reflects totally.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
plane { z, 6 pigment { checker rgb 0.95, rgb <0.2, 0.3, 0.6> } }
box { -1, 1 rotate 45*z scale <1, 1, 2> rotate <10, 25, 0> pigment { rgbf 0.98 } interior { ior 1.5 } }
