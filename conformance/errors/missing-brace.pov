// error[unclosed] 2:8
sphere { 0, 1 pigment { rgb 1 }
