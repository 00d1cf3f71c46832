// error[wrong-size] 2:10
sphere { <1, 2, 3, 4>, 1 }
