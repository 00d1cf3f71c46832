// A high adc_bailout ends faint rays.
#version 3.7;
global_settings { assumed_gamma 1 adc_bailout 0.3 max_trace_level 10 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.2 } }
sphere { -1.1*x, 1 pigment { rgb 0.1 } finish { reflection 0.5 } }
sphere { 1.1*x, 1 pigment { rgb 0.1 } finish { reflection 0.5 } }
