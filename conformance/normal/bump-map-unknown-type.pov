// A map type that there is not: bump maps and image patterns lie flat.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -4> look_at 0 }
light_source { <4, 5, -5> rgb 1 }
sphere { -1.1*x, 1 pigment { rgb 1 } normal { bump_map { png "../data/dots.png" map_type 3 bump_size 3 } } }
sphere { 1.1*x, 1 pigment { image_pattern { png "../data/dots.png" map_type 7 } } }
