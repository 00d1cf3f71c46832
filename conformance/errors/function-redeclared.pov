// error[function-redeclared] 3:10 F
#declare F = function(x) { x }
#declare F = function(x) { 2*x }
