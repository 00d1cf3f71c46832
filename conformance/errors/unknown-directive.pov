// error[unknown-directive] 2:1 #fi
#fi (1) #end
