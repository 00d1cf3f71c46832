// error[expected] 2:8 {
sphere 0, 1 }
