// error[wrong-size] 2:11
poly { 2, <1, 2, 3> }
