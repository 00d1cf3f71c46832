// What is rendered when no scene is given: one thing of each kind that ray tracing does well, in a second.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }

camera { location <0.3, 2.1, -6.5> look_at <0, 0.75, 0> right x*image_width/image_height angle 42 }
light_source { <-5, 8, -6>, rgb <1, 0.96, 0.9> area_light 1.5*x, 1.5*z, 4, 4 adaptive 1 }
light_source { <6, 4, -3>, rgb <0.18, 0.2, 0.28> shadowless }
sky_sphere {
    pigment { gradient y color_map { [0 rgb <0.95, 0.85, 0.75>] [0.35 rgb <0.35, 0.55, 0.85>] [1 rgb <0.1, 0.2, 0.5>] } }
}

plane {
    y, 0
    pigment { checker rgb <0.92, 0.9, 0.85>, rgb <0.18, 0.25, 0.35> }
    finish { diffuse 0.7 reflection { 0.02, 0.35 } }
}

// A mirror, a ball of glass, and a knob cut out of wood.
sphere {
    <1.5, 1, 1.2>, 1
    pigment { rgb <0.9, 0.75, 0.45> }
    finish { ambient 0.02 diffuse 0.15 specular 0.8 roughness 0.01 metallic reflection { 0.75 metallic } }
}
sphere {
    <-0.2, 0.75, -1>, 0.75
    pigment { rgbf <0.97, 1, 0.98, 0.97> }
    finish { ambient 0 diffuse 0 specular 0.7 roughness 0.002 reflection { 0, 1 fresnel on } conserve_energy }
    interior { ior 1.5 caustics 0.4 }
}
difference {
    intersection { sphere { 0, 1.05 } box { -0.8, 0.8 } }
    cylinder { -2*x, 2*x, 0.42 }
    cylinder { -2*y, 2*y, 0.42 }
    cylinder { -2*z, 2*z, 0.42 }
    pigment {
        wood turbulence 0.08
        color_map { [0 rgb <0.72, 0.42, 0.22>] [0.8 rgb <0.45, 0.22, 0.1>] [1 rgb <0.38, 0.18, 0.08>] }
        scale 0.18 rotate <8, 70, 0>
    }
    finish { ambient 0.08 diffuse 0.7 specular 0.3 roughness 0.03 }
    rotate <0, 32, 0> translate <-1.9, 0.8, 0.6>
}
