// error[scene-error] 3:16 too small
#declare Size = 1;
#if (Size < 2) #error "Size is too small" #end
