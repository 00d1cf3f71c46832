// error[expected] 2:18 number
sphere { <1, 2, 3; 1 }
