// `inverse` turns a sphere inside out for CSG.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
intersection { box { -1.2, 1.2 } sphere { <-0.4, 0.6, -1.2>, 1 inverse } rotate <10, 30, 0> pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
