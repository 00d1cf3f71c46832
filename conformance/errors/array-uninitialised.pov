// error[uninitialized] 3:13 A
#declare A = array[3];
sphere { 0, A[1] }
