// options: +Q4
// quick_color and quality 4: no reflection, no patterns of surfaces.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
sphere { -1.2*x, 1 pigment { checker rgb 1, rgb 0 scale 0.3 quick_color rgb <0, 1, 0> } }
sphere { 1.2*x, 1 pigment { rgb <0.8, 0.3, 0.2> } finish { reflection 0.8 phong 1 } }
