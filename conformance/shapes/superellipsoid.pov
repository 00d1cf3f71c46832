// Superellipsoids from pillow to star.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
superellipsoid { <0.3, 0.3> scale 0.8 rotate <20, 30, 0> translate -2*x pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
superellipsoid { <1, 0.2> scale 0.8 rotate <-60, 0, 0> pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
superellipsoid { <2, 2> rotate <20, 30, 0> translate 2*x pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
