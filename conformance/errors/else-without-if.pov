// error[unexpected-directive] 3:1 #else
sphere { 0, 1 }
#else
