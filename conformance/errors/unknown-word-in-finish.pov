// error[unknown-identifier] 2:24 specualr
sphere { 0, 1 finish { specualr 0.5 } }
