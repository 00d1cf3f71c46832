// Colour maps of single woods and stones.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -10 * z look_at 0 right 8 * x up 6 * y }
#include "ash.map"
box { <-4, 2.4, 0>, <4, 3, 1> pigment { gradient x color_map { M_Ash } scale 8.2 translate 4.05 * x } finish { ambient 1 diffuse 0 } }
#include "benediti.map"
box { <-4, 1.8, 0>, <4, 2.4, 1> pigment { gradient x color_map { M_Benediti } scale 8.2 translate 4.05 * x } finish { ambient 1 diffuse 0 } }
#include "bubinga.map"
box { <-4, 1.2, 0>, <4, 1.8, 1> pigment { gradient x color_map { M_Bubinga } scale 8.2 translate 4.05 * x } finish { ambient 1 diffuse 0 } }
#include "cedar.map"
box { <-4, 0.6, 0>, <4, 1.2, 1> pigment { gradient x color_map { M_Cedar } scale 8.2 translate 4.05 * x } finish { ambient 1 diffuse 0 } }
#include "marbteal.map"
box { <-4, 0, 0>, <4, 0.6, 1> pigment { gradient x color_map { M_MarbTeal } scale 8.2 translate 4.05 * x } finish { ambient 1 diffuse 0 } }
#include "orngwood.map"
box { <-4, -0.6, 0>, <4, 0, 1> pigment { gradient x color_map { M_Orangewood } scale 8.2 translate 4.05 * x } finish { ambient 1 diffuse 0 } }
#include "pinkmarb.map"
box { <-4, -1.2, 0>, <4, -0.6, 1> pigment { gradient x color_map { M_PinkMarb } scale 8.2 translate 4.05 * x } finish { ambient 1 diffuse 0 } }
#include "rdgranit.map"
box { <-4, -1.8, 0>, <4, -1.2, 1> pigment { gradient x color_map { M_RedGranite } scale 8.2 translate 4.05 * x } finish { ambient 1 diffuse 0 } }
#include "teak.map"
box { <-4, -2.4, 0>, <4, -1.8, 1> pigment { gradient x color_map { M_Teak } scale 8.2 translate 4.05 * x } finish { ambient 1 diffuse 0 } }
#include "whiteash.map"
box { <-4, -3, 0>, <4, -2.4, 1> pigment { gradient x color_map { M_WhiteAsh } scale 8.2 translate 4.05 * x } finish { ambient 1 diffuse 0 } }
