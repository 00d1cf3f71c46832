// An isosurface over a floor that shows its shadow.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.3, -4> look_at 0 angle 45 }
light_source { <3, 5, -6>, rgb 1 }
isosurface { function { x*x + y*y*1.5 + z*z - 0.6 + 0.15*sin(8*x)*sin(8*y)*sin(8*z) } contained_by { box { -1.1, 1.1 } } max_gradient 5 accuracy 0.001 rotate <20, 30, 0> pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
plane { y, -1.1 pigment { rgb 0.8 } }
