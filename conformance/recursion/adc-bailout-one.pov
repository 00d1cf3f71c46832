// With an adc_bailout of 1 no surface counts, and what is behind everything does.
#version 3.7;
global_settings { assumed_gamma 1 adc_bailout 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
background { rgb <0.4, 0.5, 0.7> }
plane { y, -1 pigment { rgb 0.9 } }
sphere { 0, 1 pigment { checker rgb 0.9, rgb 0.2 } finish { reflection 0.5 } }
