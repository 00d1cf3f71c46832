// error[missing-semicolon] 2:16
#declare A = 1 < 2;
