// error[unexpected] 3:25
#declare T = texture { pigment { rgb 1 } }
sphere { 0, 1 pigment { T } }
