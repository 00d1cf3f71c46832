// Turner Whitted's figure of 1980: two spheres over a chequered floor, one of glass, one a mirror.
//
// It showed for the first time what recursion adds: I = I_local + k_r * I_reflected + k_t * I_transmitted.
// The glass has nearly the index of air, as in the original, so that the floor is seen through it hardly bent;
// its faint reflection of the mirror ball needs the second level, the mirror's picture of the glass the third.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }

camera { location <0, 1.6, -7> look_at <0.2, 0.7, 0> right x*image_width/image_height angle 44 }
light_source { <-6, 11, -9>, rgb 1.1 }
background { rgb <0.23, 0.45, 0.78> }

// The floor ends: the horizon of an endless one would tell more of anti-aliasing than of recursion.
box {
    <-5, -1, -4>, <7, -0.9, 14>
    pigment { checker rgb <0.86, 0.12, 0.08>, rgb <0.95, 0.83, 0.12> scale 1.2 }
    finish { ambient 0.15 diffuse 0.75 }
}

// The ball of glass in front.
sphere {
    <-0.35, 1.15, -1.6>, 1.05
    pigment { rgbf <1, 1, 1, 0.95> }
    finish { ambient 0 diffuse 0.05 specular 0.6 roughness 0.003 reflection 0.12 }
    interior { ior 1.06 }
}

// The mirror behind it.
sphere {
    <1.35, 0.35, 0.8>, 1.05
    pigment { rgb <0.55, 0.6, 0.65> }
    finish { ambient 0.05 diffuse 0.2 specular 0.7 roughness 0.01 reflection 0.7 }
}
