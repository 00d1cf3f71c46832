// error[missing-semicolon] 3:1 ;
#declare A = <1, 2, 3>
sphere { A, 1 }
