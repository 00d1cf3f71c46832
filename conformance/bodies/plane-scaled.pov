// A plane, its pattern a thousand times larger; a slab of it a thousand times smaller before the camera.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location 0 look_at z angle 45 }
light_source { <30000, 50000, -60000>, rgb 1 }
#declare Look = texture { pigment { checker rgb 0.9 rgb <0.75, 0.55, 0.35> } }
plane { y, -0.5 texture { Look } scale 1000 }
intersection { plane { y, 0.4 } plane { -y, -0.2 } plane { z, 4.5 } plane { -z, -4 } plane { x, 1 } plane { -x, 1 } texture { Look scale 0.3 } scale 0.001 }
