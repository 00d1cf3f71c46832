// error[expected] 2:12
sphere { 0 }
