// error[expected] 2:8 triangle
mesh { }
