// error[missing-semicolon] 2:23 semicolon
#declare A = <1, 2, 3>
sphere { A, 1 }
