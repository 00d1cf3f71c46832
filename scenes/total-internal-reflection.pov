// Total internal reflection: the surface of a pool, seen by a diver who looks straight up.
//
// Water has index 1.33. The whole sky above, from horizon to horizon, is squeezed into a circle of 48.6 degrees
// around the vertical (Snell's window). Beyond that angle no light comes in from above: the surface mirrors the
// pool's floor and the red ball without any loss.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }

camera { location <0, -2.6, 0> right x*image_width/image_height up y direction z sky z look_at <0, 0, 0.001> angle 128 }
light_source { <6, 14, 4>, rgb 1.1 }
sky_sphere {
    pigment { gradient y color_map { [0 rgb <1, 0.9, 0.75>] [0.25 rgb <0.45, 0.65, 0.95>] [1 rgb <0.15, 0.3, 0.7>] } }
}

// The water: everything below y = 0, the diver in it.
plane {
    y, 0
    hollow
    pigment { rgbf <0.97, 1, 1, 0.98> }
    finish { ambient 0 diffuse 0 specular 0.3 roughness 0.001 reflection { 0, 1 fresnel on } conserve_energy }
    interior { ior 1.33 }
}

// The pool: floor, walls, and a ball that hangs in the water.
box {
    <-7, -4, -7>, <7, 0.15, 7> inverse
    pigment { checker rgb <0.55, 0.8, 0.85>, rgb <0.85, 0.95, 0.95> }
    clipped_by { plane { y, 0.1 } }
    hollow
}
sphere { <2.6, -1.2, 1.2>, 0.7 pigment { rgb <0.9, 0.2, 0.15> } finish { phong 0.6 } }

// Posts around the pool: in the window they all lean inwards.
#for (I, 0, 11)
    cylinder {
        <9, 0, 0>, <9, 6, 0>, 0.5
        rotate y*30*I
        pigment { gradient y color_map { [0.5 rgb <0.9, 0.5, 0.1>] [0.5 rgb 0.95] } scale 2 }
    }
#end
