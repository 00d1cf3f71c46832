// The object of an object pattern, moved inside the pattern, and the whole pattern after it.
#version 3.7;
global_settings { assumed_gamma 1 }
#default { finish { ambient 1 diffuse 0 } }
camera { orthographic location -5*z look_at 0 right 4*x up 3*y }
#declare Ball = sphere { x, 1 }
plane { -z, 0 pigment { object { Ball scale <0.5, 1, 1> translate 0.3*y rgb <0.2, 0.3, 0.6> rgb <0.9, 0.3, 0.2> } translate -0.7*x } }
