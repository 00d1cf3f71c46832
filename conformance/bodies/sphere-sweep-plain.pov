// A sphere sweep over a floor that shows its shadow.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.3, -4> look_at 0 angle 45 }
light_source { <3, 5, -6>, rgb 1 }
sphere_sweep { cubic_spline 5, <-1.6, -0.9, 0>, 0.2, <-0.8, -0.4, 0>, 0.3, <0, 0.6, 0.2>, 0.25, <0.7, -0.3, 0>, 0.35, <1.5, 0.4, 0>, 0.3 tolerance 0.0001 pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
plane { y, -1.1 pigment { rgb 0.8 } }
