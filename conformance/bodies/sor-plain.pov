// A surface of revolution over a floor that shows its shadow.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.3, -4> look_at 0 angle 45 }
light_source { <3, 5, -6>, rgb 1 }
sor { 6, <0.1, -1.1>, <0.4, -0.9>, <0.7, -0.2>, <0.3, 0.4>, <0.5, 0.9>, <0.6, 1.1> rotate <-25, 0, 10> pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
plane { y, -1.1 pigment { rgb 0.8 } }
