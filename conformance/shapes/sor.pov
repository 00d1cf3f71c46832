// A surface of revolution, closed and open.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
#declare Vase = sor { 6, <0.6, -1.6>, <0.7, -1.2>, <1.1, -0.4>, <0.4, 0.5>, <0.7, 1.2>, <0.9, 1.5> }
object { Vase rotate -20*x translate -1.3*x pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
sor { 6, <0.6, -1.6>, <0.7, -1.2>, <1.1, -0.4>, <0.4, 0.5>, <0.7, 1.2>, <0.9, 1.5> open rotate -35*x translate 1.3*x pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
