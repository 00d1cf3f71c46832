// error[expected] 2:37
#declare S = spline { linear_spline }
