// error[unclosed] 2:1 comment
/* no end
sphere { 0, 1 }
