// The four map types.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z look_at 0 right 8*x up 6*y }
box { <-1, -1, -1>, <1, 1, 1> pigment { image_map { png "../data/colors.png" map_type 0 interpolate 2 } scale 1.3 } translate <-1.9, 1.4, 0> finish { ambient 1 diffuse 0 } }
sphere { 0, 1.2 pigment { image_map { png "../data/colors.png" map_type 1 interpolate 2 }  } translate <1.9, 1.4, 0> finish { ambient 1 diffuse 0 } }
cylinder { -y, y, 1.2 pigment { image_map { png "../data/colors.png" map_type 2 interpolate 2 } scale <1, 2, 1> translate -y } translate <-1.9, -1.4, 0> finish { ambient 1 diffuse 0 } }
torus { 0.9, 0.45 rotate -50*x pigment { image_map { png "../data/colors.png" map_type 5 interpolate 2 } rotate -50*x } translate <1.9, -1.4, 0> finish { ambient 1 diffuse 0 } }
