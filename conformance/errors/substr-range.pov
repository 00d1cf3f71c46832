// error[substr-range] 2:15
#debug substr("abc", 3, 4)
