// #default acts from its line on, at the use of an object without a texture of its own.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
sphere { -2*x, 0.8 pigment { rgb 0.7 } }
#declare Ball = sphere { 0, 0.8 }
#default { pigment { rgb <0.9, 0.2, 0.2> } finish { ambient 0.3 phong 0.8 } }
object { Ball }
sphere { 2*x, 0.8 }
