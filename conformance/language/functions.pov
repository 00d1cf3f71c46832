// User functions: parameters, select, sum, and a function of functions.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
#declare Wave = function(a, k) { sin(k*a)/k }
#declare Series = function(a) { sum(k, 1, 5, Wave(a, 2*k - 1)) }
#declare Cut = function(a) { select(a, -0.5, a, min(a, 0.6)) }
#for (X, -3, 3, 0.1)
    sphere { <X, Series(X), 0>, 0.09 pigment { rgb <0.9, 0.3, 0.2> } }
    sphere { <X, Cut(X) - 1, 0>, 0.09 pigment { rgb <0.2, 0.6, 0.9> } }
#end
