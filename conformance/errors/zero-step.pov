// error[zero-step] 2:16
#for (I, 1, 3, 0) #end
