// Pictures that are not repeated, over a checker.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z look_at 0 right 8*x up 6*y }
plane { -z, -1 pigment { checker rgb 0.2, rgb 0.7 } finish { ambient 1 diffuse 0 } }
box { <-1.7, -1.2, 0>, <1.7, 1.2, 0.1> pigment { image_map { png "../data/colors.png" once  } scale 1.6 translate <-0.8, -0.8, 0> } translate <-2, 1.5, 0> finish { ambient 1 diffuse 0 } }
box { <-1.7, -1.2, 0>, <1.7, 1.2, 0.1> pigment { image_map { png "../data/colors.png" once interpolate 2 } scale 1.6 translate <-0.8, -0.8, 0> } translate <2, 1.5, 0> finish { ambient 1 diffuse 0 } }
box { <-1.7, -1.2, 0>, <1.7, 1.2, 0.1> pigment { image_map { png "../data/colors.png" once interpolate 3 } scale 1.6 translate <-0.8, -0.8, 0> } translate <-2, -1.5, 0> finish { ambient 1 diffuse 0 } }
box { <-1.7, -1.2, 0>, <1.7, 1.2, 0.1> pigment { image_map { png "../data/colors.png" once map_type 2 } scale 1.6 translate <-0.8, -0.8, 0> } translate <2, -1.5, 0> finish { ambient 1 diffuse 0 } }
