// Light leaves an isosurface too, although rays to the camera see only its first surface.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
isosurface { function { x*x + y*y + z*z - 1 } contained_by { sphere { 0, 1.2 } } max_gradient 3 pigment { rgbf <0.9, 1, 0.8, 0.6> } }
plane { y, -1.2 pigment { rgb 0.8 } }
