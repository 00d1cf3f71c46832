// Cones: a tip, a frustum, an open one.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
cone { -y, 0.9, y, 0 translate -2*x pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
cone { -y, 0.3, y, 0.9 rotate -30*x pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
cone { -y, 0.9, y, 0.4 open rotate -40*x translate 2*x pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
