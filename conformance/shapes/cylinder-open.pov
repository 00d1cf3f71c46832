// Open and closed cylinders.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
cylinder { -y, y, 0.8 rotate <-40, 0, 20> translate -1.3*x pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
cylinder { -y, y, 0.8 open rotate <-40, 0, -20> translate 1.3*x pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
