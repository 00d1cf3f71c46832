// Records the normals that facets make: pictures of a tilted plane under three coloured lights, 16 bits a channel, one for
// each statement. What each light adds is the cosine of the angle to it, so that the normal follows from the colour.
//
//   povray +Ifacets.pov +Ofacets-1.png Declare=Nr=1 -D +W25 +H20 -A +FN16 File_Gamma=1    and so on up to 4
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> direction z right 4*x up 3.2*y }
light_source { <3, 0, -9> * 1000 rgb <1, 0, 0> parallel point_at 0 shadowless }
light_source { <-3, 3, -9> * 1000 rgb <0, 1, 0> parallel point_at 0 shadowless }
light_source { <0, -3, -9> * 1000 rgb <0, 0, 1> parallel point_at 0 shadowless }
plane {
  <0.2, 0.3, -1>, 0
  pigment { rgb 1 }
  normal {
    #switch (Nr)
      #case (1) facets 0.5 size 0.3 metric 2 #break
      #case (2) facets 0.5 coords 0.5 size 0.4 metric 2 #break
      #case (3) facets 0.5 coords 0.3 size 0.4 metric 1 #break
      #case (4) facets 0.5 coords 0.3 size 0.4 metric 3 #break
    #end
  }
  finish { ambient 0 diffuse 1 }
}
