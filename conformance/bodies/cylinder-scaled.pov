// A cylinder, a thousand times smaller and a thousand times larger, each as far away as its size asks for.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location 0 look_at z angle 45 }
light_source { <30000, 50000, -60000>, rgb 1 }
#declare Thing = cylinder { <-0.5, -0.7, 0.2>, <0.4, 0.7, -0.3>, 0.5 pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
object { Thing scale <1, 0.8, 1.1> rotate 20*z translate <-1, 0.2, 4> scale 0.001 }
object { Thing scale <1, 0.8, 1.1> rotate 20*z translate <1, -0.2, 4> scale 1000 }
