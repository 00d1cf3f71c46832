// error[rand-stream] 2:13
sphere { 0, rand(5) }
