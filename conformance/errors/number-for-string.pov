// error[expected] 2:8 string
#debug 42
