// Slanted planes have no bounds, so hardly any photon is aimed at what they enclose, and light does not get through it.
#version 3.7;
global_settings { assumed_gamma 1 photons { count 20000 autostop 0 } }
camera { location <0, 5, -7> look_at 0 angle 40 }
light_source { <5, 20, -5> 1 }
plane { y, -1 pigment { checker rgb 1 rgb 0.6 } }
intersection {
    plane { x + 0.3*y, 1 } plane { -x - 0.3*y, 1 }
    plane { y + 0.1*z, 1 } plane { -y - 0.1*z, 1 }
    plane { z + 0.2*x, 1 } plane { -z - 0.2*x, 1 }
    pigment { rgbt <0.9, 0.6, 0.5, 0.7> }
    interior { ior 1.5 }
    photons { target refraction on reflection on }
}
