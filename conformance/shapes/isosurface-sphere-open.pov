// An isosurface in a sphere, open where the sphere cuts it.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
isosurface { function { y - 0.4*sin(3*x)*cos(3*z) } contained_by { sphere { 0, 1.6 } } max_gradient 2 open rotate -30*x pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
