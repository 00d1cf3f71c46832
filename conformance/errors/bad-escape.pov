// error[bad-escape] 2:11
#debug "a \q b"
