// error[rand-stream] 2:18
sphere { 0, rand(5) }
