// error[expected] 2:16
light_source { rgb 1 }
