// error[argument-count] 3:13 2 arguments
#declare F = function(a, b) { a + b }
sphere { 0, F(1) }
