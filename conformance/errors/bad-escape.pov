// error[bad-escape] 2:8
#debug "a \q b"
