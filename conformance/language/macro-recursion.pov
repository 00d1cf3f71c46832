// A recursive macro grows a tree.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
#macro Branch(Depth, Size)
    cylinder { 0, y*Size, 0.08*Size pigment { rgb <0.5, 0.35, 0.2> } }
    #if (Depth > 0)
        union { Branch(Depth - 1, Size*0.7) rotate z*35 translate y*Size }
        union { Branch(Depth - 1, Size*0.7) rotate -z*25 translate y*Size }
    #end
#end
union { Branch(5, 1.2) translate -y*1.8 }
