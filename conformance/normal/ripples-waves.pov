// ripples and waves on a plane.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
plane { y, -1 pigment { rgb <0.7, 0.7, 0.75> } finish { phong 0.6 phong_size 30 } normal { ripples 0.4 frequency 1 } clipped_by { plane { x, 0 } } }
plane { y, -1 pigment { rgb <0.7, 0.7, 0.75> } finish { phong 0.6 phong_size 30 } normal { waves 0.4 frequency 1 } clipped_by { plane { -x, 0 } } }
