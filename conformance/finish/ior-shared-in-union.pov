// The ior that an old finish gives to a part is that of all parts without an interior; the last one counts.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -6> look_at 0 angle 50 }
light_source { <5, 9, -9> 1 }
background { rgb 1 }
plane { y, -1.2 pigment { checker rgb 1 rgb <0.2, 0.3, 0.6> } }
#declare Old = texture { pigment { rgbf <0.85, 0.95, 1, 0.7> } finish { ior 1.3 diffuse 0.03 } }
#declare Plain = texture { pigment { rgbf <1, 0.9, 0.8, 0.7> } finish { diffuse 0.03 } }
union {
    sphere { -1.1*x, 1 texture { Old finish { ior 2 } } }
    sphere { 1.1*x, 1 texture { Plain } }
    object { intersection { sphere { 1.5*y, 0.9 } box { <-1, 1, -1>, <1, 3, 1> } texture { Old } } }
}
