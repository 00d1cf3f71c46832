// error[array-type] 2:28
#declare A = array[2] { 1, "two" }
