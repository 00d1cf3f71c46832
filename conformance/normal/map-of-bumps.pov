// A map of normals counts also for patterns that bend normals by rules of their own.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -4> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
#declare Among = normal { bumps normal_map { [0 gradient x 0.6 scale 0.2] [0.5 wood 0] [1 ripples 0.6 scale 0.2] } scale 0.4 }
sphere { -0.9*x, 0.8 pigment { rgb 0.8 } normal { Among } }
sphere { 0.9*x, 0.8 pigment { rgb 0.8 } normal { Among waves } }
