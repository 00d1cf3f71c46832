// A thin torus with sturm.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
torus { 1.5, 0.1 sturm rotate <-70, 0, 25> pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
