// What a pattern finds of the pigment whose place it takes: transforms (of a plain colour too), waves, colours given.
#version 3.7;
global_settings { assumed_gamma 1 }
#default { finish { ambient 1 diffuse 0 } }
camera { orthographic location -5*z look_at 0 right 4*x up 3*y }
#macro Tile(I) box { -0.48, 0.48 translate <mod(I, 4) - 1.5, div(I, 4) - 1, 0> } #end
object { Tile(0) pigment { rgb 1 } translate <0.3, 0.2, 0.1> pigment { checker rgb 0 rgb 1 scale 0.3 } }
object { Tile(1) texture { pigment { rgb 1 scale 2 } } pigment { bozo scale 0.1 } }
object { Tile(2) pigment { rgb 1 warp { turbulence 0.5 } } pigment { gradient x scale 0.3 } }
object { Tile(3) pigment { gradient x } pigment { bozo scale 0.2 } }
object { Tile(4) pigment { bozo color_map { [0 rgb <1, 0, 0>] [1 rgb <1, 1, 0>] } } pigment { gradient y } }
object { Tile(5) pigment { checker } pigment { gradient x } }
object { Tile(6) pigment { marble } pigment { gradient x scale 0.5 } }
object { Tile(7) pigment { gradient x frequency 3 sine_wave } pigment { onion } }
object { Tile(8) pigment { checker rgb 1 rgb 0 frequency 3 } pigment { gradient x } }
object { Tile(9) pigment { gradient x sine_wave } pigment { marble scale 0.5 } }
object { Tile(10) pigment { gradient x frequency 4 } pigment { checker rgb 0 rgb 1 scale 0.3 } }
object { Tile(11) pigment { bozo phase 0.3 } pigment { gradient x } }
