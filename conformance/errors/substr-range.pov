// error[substr-range] 2:8
#debug substr("abc", 3, 4)
