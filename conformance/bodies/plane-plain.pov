// A plane.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.3, -4> look_at 0 angle 45 }
light_source { <3, 5, -6>, rgb 1 }
plane { <0.2, 1, -0.3>, -0.1 pigment { checker rgb 0.9 rgb <0.75, 0.55, 0.35> scale 0.7 } finish { phong 0.4 } }
