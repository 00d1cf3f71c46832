// The object pattern colours inside and outside.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z look_at 0 right 8*x up 6*y }
box { <-4, -3, 0>, <4, 3, 1> pigment { object { torus { 1.8, 0.6 rotate 80*x } rgb <0.1, 0.2, 0.5>, rgb <1, 0.8, 0.2> } }  finish { ambient 1 diffuse 0 } }
