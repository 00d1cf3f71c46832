// min_extent and max_extent of a union.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
#declare Part = union { sphere { <-1, 0.5, 0>, 0.5 } box { 0, <1.5, 1, 0.5> } }
object { Part pigment { rgb <0.8, 0.5, 0.3> } }
sphere { min_extent(Part), 0.2 pigment { rgb <1, 0, 0> } }
sphere { max_extent(Part), 0.2 pigment { rgb <0, 0, 1> } }
