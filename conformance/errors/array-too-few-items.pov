// error[array-items] 2:30
#declare A = array[3] { 1, 2 }
