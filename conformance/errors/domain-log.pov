// error[domain] 2:13 log
sphere { 0, log(0) }
