// error[out-of-range] 2:14
polynomial { 36, xyz(1, 0, 0): 1 }
