// What has no inside in combinations: nothing is in it, turned inside out or not; and of a mesh without an
// inside_vector only what the ray meets first is seen.
#version 3.7;
global_settings { assumed_gamma 1 }
#default { finish { ambient 0.6 diffuse 0.4 } }
camera { location -11*z look_at 0 angle 50 }
light_source { <3, 5, -9>, rgb 1 }
#macro Place(I) translate <mod(I, 4)*2.2 - 3.3, div(I, 4)*2.2 - 2.2, 0> #end
#declare Cube = box { -0.8, 0.8 rotate <20, 30, 0> pigment { rgb <0.9, 0.2, 0.2> } }
#declare Far = box { <-9, -9, 0.5>, 9 pigment { rgb <0.9, 0.2, 0.2> } }
#declare Green = pigment { rgb <0.2, 0.8, 0.2> }
#declare Sides = texture { pigment { Green } }
#declare One = triangle { <-1, -1, 0>, <1, -1, 0>, <0, 1, 0> };
#declare Sheet = mesh { triangle { <-1, -1, 0>, <1, -1, 0>, <0, 1, 0> } };
#macro Two() triangle { <-1, -1, 0>, <0.5, -1, 0>, <0, 1, 0> } triangle { <-0.5, -1, 1>, <1, -1, 1>, <0, 1, 1> } #end
#declare Patch = bicubic_patch { type 1 u_steps 3 v_steps 3
    <-1, -1, 0> <-.3, -1, 0> <.3, -1, 0> <1, -1, 0>, <-1, -.3, 0> <-.3, -.3, -1> <.3, -.3, -1> <1, -.3, 0>,
    <-1, .3, 0> <-.3, .3, -1> <.3, .3, -1> <1, .3, 0>, <-1, 1, 0> <-.3, 1, 0> <.3, 1, 0> <1, 1, 0> }
difference { object { Cube } object { One pigment { Green } } Place(0) }
difference { object { Cube } polygon { 4, <-1, -1>, <1, -1>, <0, 1>, <-1, -1> pigment { Green } } Place(1) }
difference { object { Cube } object { Patch pigment { Green } } Place(2) }
difference { object { Cube } union { object { Sheet } sphere { -0.8*z, 0.5 } pigment { Green } } Place(3) }
intersection { object { Cube } object { Sheet inverse pigment { Green } } Place(4) }
difference { object { Cube } object { Sheet texture { Sides } interior_texture { pigment { rgb z } } rotate 20*x } Place(5) }
object { Patch inverse texture { Sides } interior_texture { pigment { rgb z } } rotate 160*x Place(6) }
object { Sheet inverse texture { Sides } interior_texture { pigment { rgb z } } rotate 160*x Place(7) }
intersection { mesh { Two() pigment { Green } } object { Far } Place(8) }
intersection { mesh { Two() hierarchy off pigment { Green } } object { Far } Place(9) }
difference { mesh { Two() pigment { Green } } box { -9, <9, 9, 0.5> pigment { rgb x } } Place(10) }
mesh { Two() pigment { Green } clipped_by { box { <-9, -9, 0.5>, 9 } } Place(11) }
