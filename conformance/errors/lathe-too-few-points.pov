// error[out-of-range] 2:22
lathe { cubic_spline 2, <0, 0>, <1, 1> }
