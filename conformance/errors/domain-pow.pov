// error[domain] 2:16 pow
sphere { 0, pow(0, 0) }
