// error[misplaced-word] 2:33 radius
light_source { <1, 2, 3>, rgb 1 radius 10 spotlight }
