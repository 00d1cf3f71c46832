// error[expected] 3:32
#declare V = <1, 2, 3>;
#declare F = function(x) { x + V }
