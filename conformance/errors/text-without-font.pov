// error[expected] 2:8 ttf
text { "a" "b" 1, 0 }
