// error[reserved-word] 2:10 sphere
#declare sphere = 1;
