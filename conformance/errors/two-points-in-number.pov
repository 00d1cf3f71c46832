// error[unexpected] 2:14
sphere { 0, 1..5 }
