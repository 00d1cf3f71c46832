// error[bad-lathe] 2:9
lathe { cubic_spline 2, <0, 0>, <1, 1> }
