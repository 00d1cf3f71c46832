// error[out-of-range] 2:15
prism { 0, 1, 2 <0, 0>, <1, 1> }
