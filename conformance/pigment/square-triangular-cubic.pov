// square, triangular and cubic.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z look_at 0 right 8*x up 6*y }
box { <-4, -3, 0>, <-1.3, 3, 1> pigment { square pigment { rgb 1 } pigment { rgb <1, 0, 0> } pigment { rgb <0, 1, 0> } pigment { rgb <0, 0, 1> } rotate 90*x translate 0.1 } finish { ambient 1 diffuse 0 } }
box { <-1.3, -3, 0>, <1.3, 3, 1> pigment { triangular pigment { rgb 1 } pigment { rgb <1, 0, 0> } pigment { rgb <0, 1, 0> } pigment { rgb <0, 0, 1> } pigment { rgb <1, 1, 0> } pigment { rgb <0, 1, 1> } rotate 90*x } finish { ambient 1 diffuse 0 } }
sphere { <2.7, 0, 0>, 1.3 pigment { cubic pigment { rgb <1, 0, 0> } pigment { rgb <0, 1, 0> } pigment { rgb <0, 0, 1> } pigment { rgb <1, 1, 0> } pigment { rgb <1, 0, 1> } pigment { rgb <0, 1, 1> } rotate 20 translate x*2.7 } finish { ambient 1 diffuse 0 } }
