// A macro sees the locals of the macro that called it.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
#declare Radius = 0.2;
#macro Ball() sphere { 0, Radius pigment { rgb <0.9, 0.7, 0.2> } } #end
#macro Big() #local Radius = 1.2; object { Ball() } #end
object { Big() translate -x }
object { Ball() translate x*1.5 }
