// error[expected] 2:13
sphere { 0, "one" }
