// error[bad-angle] 2:44 angle
camera { location -5*z look_at 0 angle 180 }
