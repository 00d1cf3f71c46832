// error[missing-semicolon] 2:10
#declare A = 1 < 2;
