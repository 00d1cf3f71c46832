// error[bad-prism] 2:9
prism { 0, 1, 2 <0, 0>, <1, 1> }
