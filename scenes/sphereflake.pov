// The sphereflake of Eric Haines' Standard Procedural Databases (1987): every sphere carries nine of a third of its
// size, six around its equator and three above. Depth 5 makes 1 + 9 + ... + 9^5 = 66,430 spheres.
//
// It shows that the time grows with the logarithm of the number of objects, once there is a search structure.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 }

#declare Depth = 5;

camera { location <2.1, 1.6, -2.1>*1.25 look_at <0, 0.1, 0> right x*image_width/image_height angle 40 }
light_source { <-4, 6, -6>, rgb <1, 0.95, 0.85> }
light_source { <6, 5, -2>, rgb <0.35, 0.4, 0.5> }
background { rgb <0.05, 0.12, 0.25> }

#declare Look = texture {
    pigment { rgb <1, 0.75, 0.33> }
    finish { ambient 0.1 diffuse 0.55 specular 0.5 roughness 0.03 metallic reflection { 0.25 metallic } }
}

// A sphere at the origin, and its children on the side of +y and around.
#macro Flake(Level)
    #if (Level = 0)
        sphere { 0, 0.5 }
    #else
        // Declared once for each level: what is repeated is a copy.
        #local Child = union { Flake(Level - 1) scale 1/3 translate y*(0.5 + 0.5/3) }
        union {
            sphere { 0, 0.5 }
            #for (I, 0, 5) object { Child rotate x*90 rotate y*60*I } #end
            #for (I, 0, 2) object { Child rotate x*30 rotate y*(120*I + 30) } #end
        }
    #end
#end

union { Flake(Depth) texture { Look } rotate <-15, 20, 10> }

plane {
    y, -0.78
    pigment { rgb <0.75, 0.78, 0.85> }
    finish { ambient 0.1 diffuse 0.6 reflection 0.1 }
}
