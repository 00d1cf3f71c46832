// Densities without a map have the colours of pigments.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -4> look_at 0 angle 55 }
#declare Ball = sphere { 0, 0.8 hollow pigment { rgbt 1 } }
object { Ball interior { media { emission 0.6 method 3 jitter 0 samples 10 density { wood scale 0.4 } } } translate -0.9*x }
object { Ball interior { media { emission 0.6 method 3 jitter 0 samples 10 density { gradient y density_map { [0 radial] [1 marble] } } } } translate 0.9*x }
plane { -z, -1 pigment { rgb 0.2 } finish { emission 1 } }
