// error[not-an-array] 3:13 A
#declare A = 1;
sphere { 0, A[0] }
