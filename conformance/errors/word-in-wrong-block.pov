// error[unexpected] 2:31 roughness
sphere { 0, 1 pigment { rgb 1 roughness 0.1 } }
