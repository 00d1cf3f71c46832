// error[reserved-word] 2:10 red
#macro M(red) #end
