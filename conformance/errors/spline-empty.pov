// error[empty-spline] 2:14
#declare S = spline { linear_spline }
