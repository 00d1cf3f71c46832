// error[argument-count] 3:1 Ball
#macro Ball(R) sphere { 0, R } #end
Ball(1, 2)
