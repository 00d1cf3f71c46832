// Declared textures, pigments, finishes, normals, transforms, colours and objects in use.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
#declare Tint = rgb <0.9, 0.6, 0.2>;
#declare Paint = pigment { Tint }
#declare Shine = finish { phong 1 phong_size 30 }
#declare Bumps = normal { bumps 0.6 scale 0.2 }
#declare Look = texture { pigment { Paint } finish { Shine } }
#declare Move = transform { scale <1, 1.4, 1> rotate z*30 }
#declare Ball = sphere { 0, 0.9 texture { Look } }
object { Ball transform { Move } translate -1.2*x }
object { Ball texture { Look normal { Bumps } } translate 1.2*x }
