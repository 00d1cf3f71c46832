// waves, ripples, wrinkles and dents as colours.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z look_at 0 right 8*x up 6*y }
#macro Panel(I, P) box { <2*I - 4, -3, 0>, <2*I - 2, 3, 1> pigment { P color_map { [0 rgb <0, 0.2, 0.4>] [1 rgb <1, 1, 0.7>] } scale 0.6 } finish { ambient 1 diffuse 0 } } #end
Panel(0, pigment { waves }) Panel(1, pigment { ripples frequency 2 }) Panel(2, pigment { wrinkles }) Panel(3, pigment { dents })
