// error[expected] 2:48
sphere { 0, 1 pigment { gradient x color_map { } } }
