// error[expected] 2:19
poly { 2, <1, 2, 3> }
