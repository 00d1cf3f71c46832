// Cylindrical, spherical, toroidal and planar warps.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
#declare Board = pigment { checker rgb <0.2, 0.3, 0.7>, rgb 1 scale <0.1, 0.2, 10> }
cylinder { -y, y, 0.7 pigment { Board warp { cylindrical } } translate -2*x }
sphere { 0, 0.9 pigment { Board warp { spherical } } }
torus { 0.6, 0.35 pigment { Board warp { toroidal major_radius 0.6 } } rotate -60*x translate 2*x }
