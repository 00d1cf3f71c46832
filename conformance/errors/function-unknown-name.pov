// error[unknown-identifier] 2:32 q
#declare F = function(x) { x + q }
