// Splines without facets: the Utah teapot as 32 spline patches, a glass goblet of one rational patch, and a trimmed
// sheet. `nurbs_patch` is an addition to POV-Ray's language, see docs/nurbs.md.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 12 }
#include "teapot.inc"

camera { location <1.5, 5.2, -11.5> look_at <0.5, 1.1, 0> right x*image_width/image_height angle 48 }
light_source { <7, 12, -8>, rgb 1 }
light_source { <-8, 7, -5>, rgb 0.3 shadowless }
background { rgb <0.6, 0.7, 0.8> }
plane { y, 0 pigment { checker rgb 0.85, rgb <0.5, 0.55, 0.6> } finish { diffuse 0.7 } }

// The points of the teapot are those of bicubic patches: degree 3, four by four.
#macro Spline_Patch(Index)
    nurbs_patch {
        points { 4, 4, #for (I, 0, 15) Teapot_Points[Teapot_Patches[Index][I]], #end }
    }
#end

union {
    #for (Part, 0, 9)
        #local Patch = Spline_Patch(Part)
        object { Patch }
        object { Patch scale <1, -1, 1> }
        #if (Part < 6)
            object { Patch scale <-1, 1, 1> }
            object { Patch scale <-1, -1, 1> }
        #end
    #end
    matrix <1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0>
    rotate y*25 translate <-1.6, 0, 1>
    pigment { rgb <0.2, 0.35, 0.6> }
    finish { ambient 0.05 diffuse 0.6 specular 0.7 roughness 0.01 reflection { 0.05, 0.3 fresnel on } conserve_energy }
    interior { ior 1.5 }
}

// A goblet: a cubic profile (radius, height) turned about y. Nine points of degree 2, every other one with the weight
// sqrt(1/2), are a circle.
#declare Profile = array[10] {
    <0, 0.02>, <0.9, 0.02>, <1, 0.1>, <0.15, 0.15>, <0.1, 0.6>, <0.1, 1.1>, <0.7, 1.25>, <1.1, 1.8>, <0.95, 2.6>, <0.85, 3>
}
#declare Circle = array[9] { <1, 0>, <1, 1>, <0, 1>, <-1, 1>, <-1, 0>, <-1, -1>, <0, -1>, <1, -1>, <1, 0> }
nurbs_patch {
    u_degree 3
    v_degree 2
    v_knots { 0, 0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1, 1 }
    points { 10, 9,
        #for (I, 0, 9)
            #for (J, 0, 8) <Profile[I].x*Circle[J].x, Profile[I].y, Profile[I].x*Circle[J].y>, #end
        #end
    }
    weights { #for (I, 0, 9) #for (J, 0, 8) #if (mod(J, 2)) sqrt(1/2), #else 1, #end #end #end }
    translate <3.6, 0, -1.2>
    pigment { rgbt <0.75, 0.95, 0.85, 0.75> }
    finish { specular 0.9 roughness 0.002 diffuse 0.3 reflection { 0.02, 0.6 fresnel on } conserve_energy }
    interior { ior 1.5 }
}

// A wavy sheet, trimmed to a rounded outline with a square hole.
nurbs_patch {
    points { 4, 4,
        <-1, 0, -1>, <-1, 0.7, -0.3>, <-1, -0.7, 0.3>, <-1, 0, 1>,
        <-0.3, 0.5, -1>, <-0.3, -0.9, -0.3>, <-0.3, 0.9, 0.3>, <-0.3, 0.5, 1>,
        <0.3, -0.5, -1>, <0.3, 0.9, -0.3>, <0.3, -0.9, 0.3>, <0.3, -0.5, 1>,
        <1, 0, -1>, <1, 0.7, -0.3>, <1, -0.7, 0.3>, <1, 0, 1>
    }
    trim {
        degree 2
        knots { 0, 0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1, 1 }
        points { 9, #for (J, 0, 8) <0.5, 0.5> + 0.48*<Circle[J].x, Circle[J].y>, #end }
        weights { #for (J, 0, 8) #if (mod(J, 2)) sqrt(1/2), #else 1, #end #end }
    }
    trim { points { 4, <0.4, 0.4>, <0.6, 0.4>, <0.6, 0.6>, <0.4, 0.6> } }
    scale 1.1 rotate <-40, 20, 0> translate <1.3, 0.75, -3.2>
    pigment { rgb <0.9, 0.6, 0.2> }
    finish { specular 0.5 roughness 0.02 }
}
