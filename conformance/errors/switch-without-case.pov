// error[switch-case] 2:1 #case
#switch (1) sphere { 0, 1 } #end
