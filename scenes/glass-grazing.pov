// A sheet of glass from above to grazing: the split between reflection and transmission follows Fresnel's equations.
//
// Near the viewer the sheet is seen steeply: 4 percent of the light is reflected, and the board below shows through.
// Towards the far end the same sheet is seen at a grazing angle, reflects nearly everything, and shows the columns
// upside down as a mirror would. Reflected and transmitted parts always add up to one.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }

camera { location <0, 2.4, -4.2> look_at <0, 0.2, 1.6> right x*image_width/image_height angle 58 }
light_source { <-6, 12, -8>, rgb 1 }
background { rgb <0.7, 0.8, 0.92> }

// The board below the glass.
box {
    <-3.4, -1.1, -4>, <3.4, -1, 16>
    pigment { checker rgb <0.95, 0.9, 0.8>, rgb <0.6, 0.25, 0.2> scale 0.8 }
    finish { ambient 0.2 }
}

// The sheet.
box {
    <-3, -0.06, -4>, <3, 0, 15>
    pigment { rgbf <0.96, 1, 0.98, 0.97> }
    finish { ambient 0 diffuse 0 specular 0.4 roughness 0.002 reflection { 0, 1 fresnel on } conserve_energy }
    interior { ior 1.5 }
}

// Columns along both edges of the sheet, one more near than the last.
#for (I, 0, 6)
    #for (Side, -1, 1, 2)
        cylinder {
            <Side*2.6, 0, 2.1*I>, <Side*2.6, 1.9, 2.1*I>, 0.22
            pigment { rgb <0.15 + 0.12*I, 0.35, 0.8 - 0.1*I> }
            finish { phong 0.4 }
        }
        sphere { <Side*2.6, 2.1, 2.1*I>, 0.34 pigment { rgb <0.95, 0.85, 0.4> } }
    #end
#end
