// One spline of each kind through the same points.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
#macro Dots(S, Tint) #for (T, 0, 4, 0.08) sphere { S(T), 0.07 pigment { rgb Tint } } #end #end
#declare A = spline { linear_spline 0, <-3, -1, 0>, 1, <-1.5, 1, 0>, 2, <0, -1, 0>, 3, <1.5, 1, 0>, 4, <3, -1, 0> }
#declare B = spline { A quadratic_spline }
#declare D = spline { A cubic_spline }
#declare E = spline { A natural_spline }
Dots(A, <1, 0, 0>) Dots(B, <0, 1, 0>) Dots(D, <0.3, 0.5, 1>) Dots(E, <1, 1, 0>)
