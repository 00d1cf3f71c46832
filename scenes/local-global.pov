// Local against global: a room with direct light only (Declare=Global=0), and with light from surface to surface (1).
//
// With the local model what the lamp does not see is black, or a guessed grey (`ambient`). Radiosity takes the
// light that the walls send each other: the ceiling is lit by the floor, and the red and green of the walls
// bleed onto the boxes.
#version 3.7;

#ifndef (Global) #declare Global = 1; #end

global_settings {
    assumed_gamma 1
    #if (Global)
        radiosity {
            pretrace_start 0.08 pretrace_end 0.01 count 150 nearest_count 8 error_bound 0.6
            recursion_limit 3 low_error_factor 0.6 gray_threshold 0 minimum_reuse 0.01 brightness 1 adc_bailout 0.005
        }
    #end
}
#default { finish { ambient 0 diffuse 0.75 } }

camera { location <0, 2.5, -7.6> look_at <0, 2.5, 0> right x*image_width/image_height angle 42 }

// The lamp: a square light with a picture of itself.
light_source {
    <0, 4.75, 0>, rgb 0.75
    area_light 1.2*x, 1.2*z, 5, 5 adaptive 1
    fade_distance 3 fade_power 2
}
box { <-0.6, 4.95, -0.6>, <0.6, 4.99, 0.6> pigment { rgb 1 } finish { emission 1 diffuse 0 } no_shadow }

#declare White = pigment { rgb <0.75, 0.74, 0.7> }
box { <-2.5, -0.1, -2.5>, <2.5, 0, 2.5> pigment { White } }
box { <-2.5, 5, -2.5>, <2.5, 5.1, 2.5> pigment { White } }
box { <-2.5, 0, 2.5>, <2.5, 5, 2.6> pigment { White } }
box { <-2.6, 0, -2.5>, <-2.5, 5, 2.5> pigment { rgb <0.7, 0.12, 0.08> } }
box { <2.5, 0, -2.5>, <2.6, 5, 2.5> pigment { rgb <0.12, 0.5, 0.12> } }
box { <-0.75, 0, -0.75>, <0.75, 3, 0.75> rotate y*18 translate <-0.9, 0, 0.8> pigment { White } }
box { <-0.75, 0, -0.75>, <0.75, 1.5, 0.75> rotate -y*18 translate <0.9, 0, -0.8> pigment { White } }
