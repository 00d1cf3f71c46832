// A thin film.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
sphere { 0, 1.5 pigment { rgb 0.4 } finish { diffuse 0.6 irid { 0.6 thickness 0.5 turbulence 0.5 } } }
