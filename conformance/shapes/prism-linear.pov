// A linear prism, with a hole, swept along y.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
prism { linear_sweep linear_spline -0.5, 0.5, 8
    <-1.2, -1>, <1.2, -1>, <0, 1.4>, <-1.2, -1>, <-0.5, -0.6>, <0.5, -0.6>, <0, 0.4>, <-0.5, -0.6>
    rotate <-60, 20, 0> pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
