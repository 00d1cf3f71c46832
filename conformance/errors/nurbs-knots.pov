// error[bad-nurbs] 2:34
nurbs_patch { u_degree 1 u_knots { 0, 0, 1 } points { 2, 4, 0, x, y, z, 0, x, y, z } }
