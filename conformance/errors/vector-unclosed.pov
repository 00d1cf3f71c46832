// error[expected] 2:18 >
sphere { <1, 2, 3; 1 }
