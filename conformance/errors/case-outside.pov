// error[unexpected-directive] 2:1 #case
#case (1)
