// bounded_by cuts nothing away; clipped_by does.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
union { sphere { -x, 0.8 } sphere { x, 0.8 } bounded_by { box { <-1.9, -0.9, -0.9>, <1.9, 0.9, 0.9> } } clipped_by { plane { y, 0.3 } } rotate -30*x pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
