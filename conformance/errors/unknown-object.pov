// error[unknown-identifier] 2:1 sphree
sphree { 0, 1 }
