// error[expected] 3:6 (
#macro Ball() sphere { 0, 1 } #end
Ball sphere { 0, 1 }
