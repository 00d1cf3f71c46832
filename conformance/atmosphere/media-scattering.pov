// Scattering media with a spotlight's beam.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <2.2, 2.2, -0.5>, rgb 4 spotlight point_at <-1, -1, 0> radius 10 falloff 14 }
box { -3, 3 hollow pigment { rgbt 1 } interior { media { scattering { 1, 0.15 extinction 0 } samples 20 } } }
plane { z, 2.9 pigment { rgb 0.5 } hollow }
