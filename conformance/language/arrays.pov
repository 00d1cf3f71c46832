// Two-dimensional arrays with an initialiser, and their sizes.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
#declare Heights = array[3][4] { {0.2, 0.5, 0.9, 1.4}, {0.4, 0.8, 1.2, 0.6}, {1.5, 0.9, 0.3, 0.7} }
#for (I, 0, dimension_size(Heights, 1) - 1)
    #for (J, 0, dimension_size(Heights, 2) - 1)
        box { <J - 2, -1.5, I - 1>, <J - 1.2, Heights[I][J] - 1.5, I - 0.2> pigment { rgb <I/2, J/3, 0.5> } }
    #end
#end
