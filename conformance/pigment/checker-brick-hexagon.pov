// The block patterns.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z look_at 0 right 8*x up 6*y }
box { <-4, -3, 0>, <-1.3, 3, 1> pigment { checker rgb <0.9, 0.2, 0.2>, rgb <0.9, 0.9, 0.5> scale 0.7 translate 0.1 } finish { ambient 1 diffuse 0 } }
box { <-1.3, -3, 0>, <1.3, 3, 1> pigment { brick rgb 0.8, rgb <0.6, 0.2, 0.1> mortar 0.2 brick_size <2, 0.8, 1> scale 0.6 translate 0.1 } finish { ambient 1 diffuse 0 } }
box { <1.3, -3, 0>, <4, 3, 1> pigment { hexagon rgb <1, 0, 0>, rgb <0, 1, 0>, rgb <0, 0, 1> rotate 90*x scale 0.7 } finish { ambient 1 diffuse 0 } }
