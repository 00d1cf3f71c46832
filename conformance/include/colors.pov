// colors.inc: names, and HSV turned to RGB.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "colors.inc"
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 4, -5>, White }
sphere { -2*x, 0.9 pigment { SkyBlue } }
sphere { 0*x, 0.9 pigment { Orange } }
sphere { 2*x, 0.9 pigment { rgb CHSV2RGB(<140, 0.7, 0.8>) } }
