// error[layered-pattern] 2:129 layered
sphere { 0, 1 texture { gradient x texture_map { [0 pigment { rgb 1 }] [1 pigment { rgb 0 }] } } texture { pigment { rgbt 1 } } }
