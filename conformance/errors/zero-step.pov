// error[zero-step] 2:7 step
#for (I, 1, 3, 0) #end
