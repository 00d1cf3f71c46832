// An isosurface, a thousand times smaller and a thousand times larger, each as far away as its size asks for.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location 0 look_at z angle 45 }
light_source { <30000, 50000, -60000>, rgb 1 }
#declare Thing = isosurface { function { x*x + y*y*1.5 + z*z - 0.6 + 0.15*sin(8*x)*sin(8*y)*sin(8*z) } contained_by { box { -1.1, 1.1 } } max_gradient 5 accuracy 0.001 rotate <20, 30, 0> pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
object { Thing scale <1, 0.8, 1.1> rotate 20*z translate <-1, 0.2, 4> scale 0.001 }
object { Thing scale <1, 0.8, 1.1> rotate 20*z translate <1, -0.2, 4> scale 1000 }
