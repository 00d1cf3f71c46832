// Two mirrors face each other: the depth ends at max_trace_level.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
plane { z, 2 pigment { rgb 0.1 } finish { reflection 0.8 } }
plane { z, -6 pigment { checker rgb <0.8, 0.3, 0.2>, rgb 0.8 } finish { reflection 0.7 ambient 0.3 } }
sphere { 0, 0.9 pigment { rgb <0.2, 0.5, 0.9> } finish { reflection 0.4 phong 0.8 } }
