// The outermost group says whether the scene's lights shine within, and lights in a union are the whole scene's.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <-3, 4, -4>, rgb <0, 0.4, 0> }
light_group {
  light_source { <3, 4, -4>, rgb <0.8, 0.4, 0> }
  light_group { light_source { <-3, 0, -4>, rgb <0, 0, 0.8> } sphere { -1.4*x, 0.6 pigment { rgb 0.8 } } global_lights on }
  union { light_source { <0, 6, 0>, rgb 0.4 } sphere { 0, 0.6 pigment { rgb 0.8 } } }
}
light_group {
  light_group { light_source { <3, 4, -4>, rgb <0.8, 0.4, 0> } sphere { 1.4*x, 0.6 pigment { rgb 0.8 } } }
  global_lights on
}
plane { y, -1 pigment { rgb 0.8 } }
