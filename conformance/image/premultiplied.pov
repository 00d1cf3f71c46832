// Alpha that the colours have been multiplied by, and alpha that they have not.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z look_at 0 right 8*x up 6*y }
plane { -z, -1 pigment { checker rgb <0.2, 0.3, 0.9>, rgb <1, 0.9, 0.3> scale 0.5 } finish { ambient 1 diffuse 0 } }
box { 0, <1, 1, 0.1> pigment { image_map { png "../data/clear.png" premultiplied on  } } finish { ambient 1 diffuse 0 } scale <4, 3, 1> translate <-4, 0, 0> }
box { 0, <1, 1, 0.1> pigment { image_map { png "../data/clear.png" premultiplied off  } } finish { ambient 1 diffuse 0 } scale <4, 3, 1> translate <0, 0, 0> }
box { 0, <1, 1, 0.1> pigment { image_map { png "../data/clear.png" premultiplied on interpolate 2 } } finish { ambient 1 diffuse 0 } scale <4, 3, 1> translate <-4, -3, 0> }
box { 0, <1, 1, 0.1> pigment { image_map { png "../data/clear.png" interpolate 2 } } finish { ambient 1 diffuse 0 } scale <4, 3, 1> translate <0, -3, 0> }
