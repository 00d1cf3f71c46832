// inside() keeps the points that lie in a solid.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
#declare Solid = difference { sphere { 0, 1.6 } box { -0.6, 3 } }
#for (X, -2, 2, 0.4) #for (Y, -2, 2, 0.4)
    #if (inside(Solid, <X, Y, -0.3>)) sphere { <X, Y, -0.3>, 0.18 pigment { rgb <0.5 + X/4, 0.5 + Y/4, 0.5> } } #end
#end #end
