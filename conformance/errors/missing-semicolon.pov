// error[missing-semicolon] 3:1 ;
#declare A = 1
sphere { 0, A }
