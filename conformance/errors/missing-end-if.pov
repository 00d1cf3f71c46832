// error[missing-end] 2:1 #end
#if (1)
sphere { 0, 1 }
