// error[expected] 2:9
#if (1 == 1) sphere { 0, 1 } #end
