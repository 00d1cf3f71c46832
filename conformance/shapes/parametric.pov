// A parametric surface: a Moebius band.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
parametric {
    function { (1 + v*cos(u/2))*cos(u) }, function { (1 + v*cos(u/2))*sin(u) }, function { v*sin(u/2) }
    <0, -0.4>, <2*pi, 0.4> contained_by { box { -1.6, 1.6 } } max_gradient 3 accuracy 0.005
    rotate <-40, 20, 0> pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 }
}
