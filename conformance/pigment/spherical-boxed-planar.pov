// spherical, boxed, cylindrical and planar.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z look_at 0 right 8*x up 6*y }
#macro Panel(I, P) box { <2*I - 4, -3, 0>, <2*I - 2, 3, 1> pigment { P color_map { [0 rgb <0.2, 0, 0.4>] [1 rgb <1, 1, 0.3>] } translate x*(2*I - 3) } finish { ambient 1 diffuse 0 } } #end
Panel(0, pigment { spherical scale 1 }) Panel(1, pigment { boxed }) Panel(2, pigment { cylindrical rotate 90*x scale 1.3 }) Panel(3, pigment { planar scale 2 })
