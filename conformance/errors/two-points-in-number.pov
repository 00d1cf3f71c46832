// error[malformed-number] 2:13
sphere { 0, 1..5 }
