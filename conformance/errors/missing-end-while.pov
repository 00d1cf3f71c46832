// error[missing-end] 3:1 #end
#declare I = 0;
#while (I < 2)
#declare I = I + 1;
