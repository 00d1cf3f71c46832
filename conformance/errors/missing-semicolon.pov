// error[missing-semicolon] 2:10
#declare A = 1
sphere { 0, A }
