// error[unexpected] 3:25
#declare B = sphere { 0, 1 }
sphere { 0, 1 texture { B } }
