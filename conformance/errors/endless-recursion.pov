// error[nested-too-deeply] 2:12
#macro M() M() #end
M()
