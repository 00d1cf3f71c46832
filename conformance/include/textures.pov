// textures.inc: one of each kind, and its four patterns.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "textures.inc"
camera { orthographic location -10*z direction z right 8*x up 6*y }
light_source { <-30, 30, -60>, rgb 1 }
background { rgb <0.3, 0.5, 0.2> }
#declare Place = -1;
#macro Material(Of)
    #declare Place = Place + 1;
    sphere { 0, 0.48 material { Of } translate <mod(Place, 8) - 3.5, 2.5 - floor(Place/8), 0> }
#end
#macro Pattern(P) Material(material { texture { pigment { P } } }) #end
#macro Pigment(P) Pattern(pigment { P scale 0.6 }) #end
#macro Texture(T) Material(material { texture { T scale 0.6 } }) #end
Pigment(Jade) Pigment(Red_Marble) Pigment(Blood_Marble) Pigment(Blue_Agate) Pigment(Sapphire_Agate) Pigment(Pink_Granite)
Pigment(Blue_Sky) Pigment(Blood_Sky) Pigment(Clouds) Pigment(Cherry_Wood) Pigment(White_Wood) Pigment(DMFWood4)
Texture(PinkAlabaster) Texture(Shadow_Clouds) Texture(DMFWood6) Texture(EMBWood1) Texture(Yellow_Pine) Texture(Rosewood)
Texture(Sandalwood) Texture(Chrome_Metal) Texture(Polished_Brass) Texture(Brushed_Aluminum) Texture(Silver2)
Texture(Rusty_Iron) Texture(New_Penny) Material(M_Glass) Material(M_NB_Old_Glass) Material(M_Ruby_Glass)
Material(M_Vicks_Bottle_Glass) Material(M_Water) Texture(Cork) Texture(Lightning1) Texture(Starfield)
Pigment(Candy_Cane) Pigment(Peel) Pigment(Y_Gradient)
#declare Map = color_map { [0 rgb <1, 0, 0>] [0.2 rgb 0] [1 rgb <0, 1, 1>] }
Pattern(pigment { Irregular_Bricks_Ptrn(0.1, 1, 0.5, 0.5) color_map { Map } scale 0.2 })
Pattern(pigment { Hex_Tiles_Ptrn() color_map { Map } rotate 90*x scale 0.2 })
Pattern(pigment { Tiles_Ptrn() color_map { Map } scale 0.3 })
Pattern(pigment { Star_Ptrn(0.4, 5, 2) color_map { Map } })
