// error[out-of-range] 2:69
sphere { 0, 1 interior { ior 1.5 dispersion 1.02 dispersion_samples 1 } }
