// error[domain] 2:13 pow
sphere { 0, pow(0, 0) }
