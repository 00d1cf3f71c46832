// interior_texture on the inside of an open box.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
cylinder { -y, y, 1.2 open rotate <-50, 0, 20> texture { pigment { rgb <0.9, 0.6, 0.2> } } interior_texture { pigment { checker rgb <0.2, 0.3, 0.8>, rgb 1 scale 0.4 } } }
