// error[unclosed] 2:8
#debug "no end
sphere { 0, 1 }
