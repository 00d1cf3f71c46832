// error[domain] 2:13 sqrt
sphere { 0, sqrt(-1) }
