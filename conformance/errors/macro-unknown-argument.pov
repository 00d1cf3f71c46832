// error[unknown-identifier] 3:6 Size
#macro Ball(R) sphere { 0, R } #end
Ball(Size)
