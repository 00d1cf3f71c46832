// A plate with ten thousand holes: one difference of as many cylinders. The time of a ray must grow with the logarithm
// of their number; render with --declare Side=10, 32 and 100 to see.
#version 3.7;
global_settings { assumed_gamma 1 }

#ifndef (Side) #declare Side = 100; #end

camera { location <0.3, 1.1, -1.2> look_at <0, 0, -0.1> right x*image_width/image_height angle 50 }
light_source { <2, 4, -3> rgb 1 }
background { rgb <0.3, 0.4, 0.6> }

difference {
  box { <-0.6, -0.05, -0.6>, <0.6, 0.05, 0.6> }
  #for (I, 0, Side - 1)
    #for (J, 0, Side - 1)
      cylinder { <(I + 0.5)/Side - 0.5, -0.1, (J + 0.5)/Side - 0.5>,
                 <(I + 0.5)/Side - 0.5, 0.1, (J + 0.5)/Side - 0.5>, 0.35/Side }
    #end
  #end
  pigment { rgb <0.8, 0.6, 0.4> }
  finish { phong 0.4 }
}
