// Before version 1.5 frequency and phase in a texture were those of its ripples and waves, turbulence that of its colours.
#version 1.0
camera { location <0, 0, -7> look_at <0, 0, 0> }
light_source { <2, 3, -5> color red 1 green 1 blue 1 }
sphere { <-2, 1.1, 0>, 1 texture { wood ripples 0.7 frequency 3 } }
sphere { <0, 1.1, 0>, 1 texture { frequency 4 wood turbulence 0.2 waves 0.6 } }
sphere { <2, 1.1, 0>, 1 texture { color red 1 ripples 0.7 frequency 8 phase 0.3 phong 1 } }
sphere { <-1, -1.1, 0>, 1 texture { bozo bumps 0.5 frequency 5 scale <0.3, 0.3, 0.3> } }
sphere { <1, -1.1, 0>, 1 texture { color red 0.8 green 0.7 waves 0.5 frequency 20 phase 2 } }
