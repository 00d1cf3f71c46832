// error[function-exists] 3:10 #undef
#declare F = function(x) { x }
#declare F = function(x) { 2*x }
