// shapes2.inc and shapesq.inc.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "shapes.inc"
#include "shapes_old.inc"
#include "shapes2.inc"
#include "shapesq.inc"
camera { orthographic location -60*z direction z right 16*x up 12*y }
light_source { <-100, 100, -300>, rgb 1 }
#declare Place = -1;
#macro Next(O)
    #declare Place = Place + 1;
    object { O pigment { rgb <0.8, 0.4, 0.2> } rotate <-25, 35, 0> translate <2.6*mod(Place, 6) - 6.5, 4.5 - 3*floor(Place/6), 0> }
#end
#macro Part(O) Next(object { O clipped_by { sphere { 0, 1.2 } } }) #end
Next(object { Tetrahedron scale 0.5 }) Next(Octahedron) Next(Dodecahedron) Next(Icosahedron) Next(HalfCone_Y) Next(Hexagon)
Next(object { Rhomboid scale 0.7 }) Next(Pyramid) Next(Pyramid2) Next(Square_Z) Next(object { Helix }) Next(object { Torus_40_12 scale 0.1 })
Part(Bicorn) Part(Cubic_Saddle_1) Part(Devils_Curve) Part(Lemniscate) Part(Monkey_Saddle) Part(Piriform)
Part(Steiner_Surface) Part(Witch_Hat) Part(Sinsurf) Part(Twin_Glob) Part(Quartic_Cylinder) Part(Folium)
