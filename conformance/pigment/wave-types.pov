// ramp, triangle, sine, scallop, cubic and poly waves with frequency and phase.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z look_at 0 right 8*x up 6*y }
#macro Panel(I, P) box { <-4, I - 3, 0>, <4, I - 2, 1> pigment { gradient x P frequency 0.5 phase 0.2 } finish { ambient 1 diffuse 0 } } #end
#macro W(I) #switch (I) #case (0) ramp_wave #break #case (1) triangle_wave #break #case (2) sine_wave #break #case (3) scallop_wave #break #case (4) cubic_wave #break #else poly_wave 2.5 #end #end
#for (I, 0, 5) box { <-4, I - 3, 0>, <4, I - 2, 1> pigment { gradient x color_map { [0 rgb 0] [1 rgb <1, 0.9, 0.6>] } frequency 0.5 phase 0.2 W(I) } finish { ambient 1 diffuse 0 } } #end
