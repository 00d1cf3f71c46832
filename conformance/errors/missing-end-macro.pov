// error[missing-end] 2:1 #end
#macro Ball() sphere { 0, 1 }
