// clipped_by opens a sphere and shows its inside.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
sphere { 0, 1.5 clipped_by { plane { <1, 1, -1>, 0.3 inverse } } pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
