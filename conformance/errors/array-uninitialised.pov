// error[uninitialized] 3:13 no value
#declare A = array[3];
sphere { 0, A[1] }
