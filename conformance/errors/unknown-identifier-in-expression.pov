// error[unknown-identifier] 2:13 Radius
sphere { 0, Radius }
