// error[unexpected] 2:48 color_map
sphere { 0, 1 pigment { gradient x color_map { 0 rgb 1 } } }
