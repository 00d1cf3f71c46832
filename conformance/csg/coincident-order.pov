// Which of two coincident surfaces is seen: the last of a union, but in what a combination looks through the first.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -10> look_at 0 angle 50 }
light_source { <3, 5, -10>, rgb 1 }
#declare A = box { <-1, -1, 0>, <1, 1, 1> pigment { rgb <0.2, 0.3, 0.9> } }
#declare B = box { <-0.6, -0.8, 0>, <0.7, 0.6, 1> pigment { rgb <0.9, 0.8, 0.2> } }
#declare C = box { <-0.2, -0.9, 0>, <0.3, 0.9, 1> pigment { rgb <0.9, 0.3, 0.2> } }
#declare Rest = box { -2, <2, 0.7, 2> }
union { object { A } object { B } object { C } split_union off translate <-3, 1.5, 0> }
merge { object { A } object { B } object { C } translate <0, 1.5, 0> }
intersection { object { A } object { B } translate <3, 1.5, 0> }
intersection { union { object { A } object { B } object { C } } object { Rest } translate <-3, -1.5, 0> }
difference { union { object { C } object { B } object { A } } box { <-2, -2, -1>, <2, 0, 0.2> pigment { rgb 0.8 } } translate <0, -1.5, 0> }
intersection { intersection { object { A } object { B } } object { C } translate <3, -1.5, 0> }
