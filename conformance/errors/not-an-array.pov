// error[unexpected] 3:14 sphere
#declare A = 1;
sphere { 0, A[0] }
