// error[bad-map] 2:46
sphere { 0, 1 pigment { gradient x color_map { } } }
