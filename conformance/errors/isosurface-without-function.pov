// error[empty-object] 2:12 isosurface
isosurface { }
