// Superellipsoids flattened a thousand times: most digits of a far ray's distance are spent on the way to them.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <3, 5, -6> look_at 0 }
light_source { <2, 8, -5> rgb 1 }
background { rgb 0.3 }
superellipsoid { <0.1, 0.3> scale <1, 0.001, 1> pigment { rgb <1, 1, 0> } }
superellipsoid { <1, 2.5> scale <1, 1, 0.001> rotate 60*x translate <-2.5, 0, 1> pigment { rgb <0.4, 0.8, 1> } }
superellipsoid { <0.3, 1> scale <0.001, 1, 1> rotate 30*z translate 2.5*x pigment { rgb <1, 0.4, 0.4> } }
