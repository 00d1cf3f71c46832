// error[out-of-range] 2:40 angle
camera { location -5*z look_at 0 angle 180 }
