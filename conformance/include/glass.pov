// glass.inc.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "glass.inc"
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
plane { z, 4 pigment { checker rgb 0.9, rgb 0.3 } }
sphere { -1.2*x, 1.1 pigment { Col_Glass_Green } finish { F_Glass7 } interior { I_Glass3 fade_color Col_Emerald_03 } }
sphere { 1.2*x, 1.1 texture { T_Ruby_Glass } interior { I_Glass } }
