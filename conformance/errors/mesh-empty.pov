// error[empty-object] 2:6 mesh
mesh { }
