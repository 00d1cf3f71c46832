// error[argument-count] 3:13 F
#declare F = function(a, b) { a + b }
sphere { 0, F(1) }
