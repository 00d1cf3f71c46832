// error[unexpected] 2:30
julia_fractal { <0, 0, 0, 0> triangle }
