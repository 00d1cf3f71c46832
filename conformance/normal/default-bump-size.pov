// A default bump size without a pattern reaches every normal that names none, also those of a map.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5 * z right 4 * x up 3 * y direction z }
light_source { <20, 20, -10> rgb 1 }
#default { pigment { rgb 1 } normal { bump_size 1.5 } }
box {
    <-1.9, -1.4, 0>, <-0.1, 1.4, 1>
    normal { gradient x triangle_wave scale 0.3 }
}
box {
    <0.1, -1.4, 0>, <1.9, 1.4, 1>
    normal {
        gradient y triangle_wave
        normal_map { [0 gradient x triangle_wave scale 0.3] [1 gradient y sine_wave scale 0.3] }
    }
}
