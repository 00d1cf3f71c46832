// light_source { Name } takes any object.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -8> look_at 0.5*y angle 50 }
#declare Lamp = union { light_source { <3, 4, -4>, rgb 0.6 } sphere { <2, 2, 0>, 0.3 pigment { rgb <1, 0.8, 0.2> } finish { ambient 0.9 } } }
#declare Light = light_source { <-4, 5, -4>, rgb <0.2, 0.3, 0.4> }
light_source { Lamp translate -2*x }
light_source { Light translate x }
plane { y, 0 pigment { rgb 1 } }
sphere { 0.8*y, 0.8 pigment { rgb <0.8, 0.3, 0.3> } }
