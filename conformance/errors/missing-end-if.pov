// error[missing-end] 2:1 #if
#if (1)
sphere { 0, 1 }
