// A prism that ends in a point, a thousand times smaller and a thousand times larger, each as far away as its size asks for.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location 0 look_at z angle 45 }
light_source { <30000, 50000, -60000>, rgb 1 }
#declare Thing = prism { conic_sweep linear_spline 0, 1, 6 <0.9, -0.7>, <0.8, 0.6>, <-0.8, 0.8>, <-0.3, 0>, <-0.7, -0.9>, <0.9, -0.7> rotate 180*x translate 0.7*y scale 1.2 rotate <-20, 20, 0> pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
object { Thing scale <1, 0.8, 1.1> rotate 20*z translate <-1, 0.2, 4> scale 0.001 }
object { Thing scale <1, 0.8, 1.1> rotate 20*z translate <1, -0.2, 4> scale 1000 }
