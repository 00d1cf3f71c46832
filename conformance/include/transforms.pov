// transforms.inc: turning about any axis, and pointing.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "transforms.inc"
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
#declare Arrow = union { cylinder { 0, y, 0.1 } cone { y, 0.25, 1.4*y, 0 } }
#for (I, 0, 5)
    object { Arrow Point_At_Trans(vrotate(<1, 0.3, 0>, z*60*I)) pigment { rgb <I/5, 0.5, 1 - I/5> } }
#end
box { -0.2, 0.2 Axis_Rotate_Trans(<1, 1, 0>, 40) pigment { rgb 0.9 } }
