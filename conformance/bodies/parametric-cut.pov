// A parametric surface cut by solids.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.3, -4> look_at 0 angle 45 }
light_source { <3, 5, -6>, rgb 1 }
intersection {
    parametric { function { (0.6 + 0.35*cos(v))*cos(u) }, function { 0.45*sin(v) }, function { (0.6 + 0.35*cos(v))*sin(u) } <0, 0>, <2*pi, 2*pi> contained_by { box { -1, 1 } } max_gradient 2 accuracy 0.005 rotate <-40, 20, 0> pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
    union { sphere { <0.5, 0.3, 0>, 0.7 } box { <-2, -0.5, -2>, <-0.1, 0.3, 2> } }
    pigment { rgb <0.3, 0.5, 0.8> }
}
object { parametric { function { (0.6 + 0.35*cos(v))*cos(u) }, function { 0.45*sin(v) }, function { (0.6 + 0.35*cos(v))*sin(u) } <0, 0>, <2*pi, 2*pi> contained_by { box { -1, 1 } } max_gradient 2 accuracy 0.005 rotate <-40, 20, 0> pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } } clipped_by { plane { y, -0.6 } } }
