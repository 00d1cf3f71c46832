// A thin film colours total reflection inside glass.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at 0 angle 50 }
light_source { <3, 8, -5> rgb 0.5 }
background { rgb <0.6, 0.7, 0.8> }
box {
    -1, 1 rotate <0, 30, 20>
    pigment { rgbt <1, 1, 1, 1> }
    finish { ambient 0 diffuse 0 irid { 0.6 thickness 0.6 } }
    interior { ior 1.5 }
}
plane { y, -1.6 pigment { checker rgb 0.3 rgb 0.8 } }
