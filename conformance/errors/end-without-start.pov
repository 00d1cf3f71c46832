// error[unexpected-directive] 3:1 #end
sphere { 0, 1 }
#end
