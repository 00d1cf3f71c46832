// error[missing-semicolon] 2:15 semicolon
#declare A = 1
sphere { 0, A }
