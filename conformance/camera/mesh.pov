// Rays leave a mesh's faces from the side where the corners run clockwise.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Step = 0.05;
#declare Faces = mesh {
    #for (Row, 0, image_height - 1)
        #for (Column, 0, image_width - 1)
            #local P = <(Column - image_width / 2) * Step, (image_height / 2 - Row) * Step, 0>;
            triangle { P, P + <Step, Step, 0>, P + <Step, 0, 0> }
        #end
    #end
}
camera {
    mesh_camera { 1 0 mesh { Faces } }
    location <0, 0, 0.01>
}
light_source { <3, 8, -5> rgb 1 }
sphere { 3 * z, 1 pigment { rgb <1, 0.4, 0.2> } }
plane { z, 8 pigment { checker rgb 0.2 rgb 0.8 } }
sphere { -3 * z, 1.5 pigment { rgb <0, 0.4, 1> } }
