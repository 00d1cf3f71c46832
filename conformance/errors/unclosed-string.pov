// error[unclosed-string] 2:8 never closed
#debug "no end
sphere { 0, 1 }
