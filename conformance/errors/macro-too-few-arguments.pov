// error[argument-count] 3:1 Ball
#macro Ball(R, P) sphere { P, R } #end
Ball(1)
