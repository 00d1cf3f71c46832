// error[array-items] 2:31
#declare A = array[2] { 1, 2, 3 }
