// error[array-size] 2:20
#declare A = array[0];
