// error[expected] 2:13 #case
#switch (1) sphere { 0, 1 } #end
