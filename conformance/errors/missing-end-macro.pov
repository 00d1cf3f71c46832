// error[missing-end] 2:1 #macro
#macro Ball() sphere { 0, 1 }
