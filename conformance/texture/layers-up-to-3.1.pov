// Up to version 3.1 upper layers let light through untinted, whatever their colours say; images and the lowest layer tint.
#version 3.1;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -7> look_at 0 angle 45 }
light_source { <3, 5, -6>, rgb 1 }
plane { z, 3 pigment { checker rgb 1, rgb <0.5, 0.8, 0.5> } finish { ambient 0.6 } }
#declare Under = texture { pigment { rgb <0.9, 0.5, 0.2> filter 0.4 } }
#declare Over = pigment { rgb <0.3, 0.4, 0.9> filter 0.7 }
sphere { <-1.7, 1, 0>, 0.8 texture { Under } texture { pigment { Over } } }
sphere { <0, 1, 0>, 0.8 texture { Under }
    texture { pigment { gradient x color_map { [0 rgb <0.2, 0.9, 0.3> filter 0.9] [1 rgb <0.9, 0.2, 0.3> filter 0.4] } } } }
sphere { <1.7, 1, 0>, 0.8 texture { Under }
    texture { pigment { checker pigment { Over }, pigment { rgbft <0.9, 0.2, 0.2, 0.4, 0.3> } scale 0.4 } } }
sphere { <-1.7, -1, 0>, 0.8 pigment { Over } }
#version 3.7;
#declare Both = texture { Under } texture { pigment { Over } }
sphere { <0, -1, 0>, 0.8 texture { Both } }
#version 3.1;
sphere { <1.7, -1, 0>, 0.8 texture { Both } }
