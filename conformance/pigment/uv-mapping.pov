// uv_mapping on a sphere, a box and a torus.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
#declare Board = pigment { uv_mapping checker rgb <0.8, 0.3, 0.2>, rgb 1 scale <0.1, 0.2, 1> }
sphere { 0, 0.9 pigment { Board } rotate <-20, 30, 0> translate -2*x }
box { -0.7, 0.7 pigment { Board } rotate <-20, 30, 0> }
torus { 0.6, 0.35 pigment { Board } rotate -60*x translate 2*x }
