// Records what patterns say that look at the surface: pictures of a sphere of 25 x 20 points in 16 bits, one for each
// statement. slope.csv holds a statement's name and its 500 points, row by row, all separated by bars.
//
//   povray +Islope.pov +Oslope-1.png Declare=Nr=1 -D +W25 +H20 -A +FN16 File_Gamma=1    and so on up to 6
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0.1, 0.2, -5> direction z right 1.9*x up 1.9*y }
sphere {
  <0.1, 0.2, 0.3>, 1.4
  pigment {
    #switch (Nr)
      #case (1) slope { <1, 2, -0.5>, 0.2, 0.9 } #break
      #case (2) slope { <0, 2, -1>, 0.1, 0.8 altitude 3*y, -1, 2 } #break
      #case (3) slope { point_at <3, 2, -1> } #break
      #case (4) slope { point_at <3, 2, -1>, 0.3, 0.8 } #break
      #case (5) slope { <0, 2, -1> altitude <0, 2, 1>, -1, 2 } #break
      #case (6) aoi #break
    #end
    color_map { [0 rgb 0] [1 rgb 1] }
    #if (Nr = 4 | Nr = 5) scale 0.5 translate <0.2, 0.3, 0> #end
  }
  finish { ambient 1 diffuse 0 }
}
