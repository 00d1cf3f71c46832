// Fog dims the light of a lamp with media_attenuation, but not on its way through a solid sphere; right a hollow one.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -9> look_at -0.5 * y angle 50 }
light_source { <0, 12, 0> rgb 8 media_attenuation on }
fog { color rgb 0.5 distance 8 }
plane { y, -2 pigment { rgb <1, 0.8, 0.6> } hollow }
sphere { <-1.6, 0, 0>, 1.4 pigment { rgbt <1, 1, 1, 0.9> } finish { diffuse 0 ambient 0 } }
sphere { <1.6, 0, 0>, 1.4 pigment { rgbt <1, 1, 1, 0.9> } finish { diffuse 0 ambient 0 } hollow }
