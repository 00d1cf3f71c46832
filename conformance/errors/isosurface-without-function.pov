// error[expected] 2:14 function
isosurface { }
