// error[unexpected] 2:1
rgb 1
