// error[unexpected-directive] 2:1 #break
#break
