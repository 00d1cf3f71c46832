// max_trace_level 2 cuts off.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 2 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.2 } }
sphere { -1.1*x, 1 pigment { rgb 0 } finish { reflection 0.9 } }
sphere { 1.1*x, 1 pigment { rgb 0 } finish { reflection 0.9 } }
