// What the scene says about the encoding of a file.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z look_at 0 right 8*x up 6*y }
box { 0, <1, 1, 0.1> pigment { image_map { png "../data/colors.png"    } } finish { ambient 1 diffuse 0 } scale <4, 2, 1> translate <-4, 1, 0> }
box { 0, <1, 1, 0.1> pigment { image_map { png "../data/colors.png" gamma srgb   } } finish { ambient 1 diffuse 0 } scale <4, 2, 1> translate <0, 1, 0> }
box { 0, <1, 1, 0.1> pigment { image_map { png "../data/colors.png" gamma 1.0   } } finish { ambient 1 diffuse 0 } scale <4, 2, 1> translate <-4, -1, 0> }
box { 0, <1, 1, 0.1> pigment { image_map { png "../data/colors.png" gamma 2.2   } } finish { ambient 1 diffuse 0 } scale <4, 2, 1> translate <0, -1, 0> }
box { 0, <1, 1, 0.1> pigment { image_map { png "../data/colors.png" gamma 1.5   } } finish { ambient 1 diffuse 0 } scale <4, 2, 1> translate <-4, -3, 0> }
box { 0, <1, 1, 0.1> pigment { image_map { png "../data/colors.png" gamma 0.7   } } finish { ambient 1 diffuse 0 } scale <4, 2, 1> translate <0, -3, 0> }
