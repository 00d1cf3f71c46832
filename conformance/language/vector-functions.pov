// vcross, vnormalize, vrotate, vaxis_rotate.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
#declare V = <1, 2, 0.5>;
cylinder { 0, V, 0.1 pigment { rgb <1, 0, 0> } }
cylinder { 0, vcross(V, y), 0.1 pigment { rgb <0, 1, 0> } }
cylinder { 0, 1.5*vnormalize(vrotate(V, <0, 0, 90>)), 0.1 pigment { rgb <0.2, 0.4, 1> } }
cylinder { 0, vaxis_rotate(V, z, -70), 0.1 pigment { rgb <1, 1, 0> } }
