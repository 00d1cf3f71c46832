// error[no-such-component] 3:15 z
#declare V = <1, 2>;
sphere { 0, V.z }
