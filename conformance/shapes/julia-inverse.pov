// A fractal takes no notice of its own `inverse`, but of that of an object around it, until that is moved.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 65 }
light_source { <3, 5, -6>, rgb 1 }
#declare Julia = julia_fractal { <-0.083, 0, -0.83, -0.025> quaternion sqr max_iteration 6 precision 15 inverse pigment { rgb <0.75, 0.55, 0.35> } }
intersection { object { Julia translate -2*x } sphere { -2*x, 1.1 } pigment { rgb 0.7 } }
intersection { object { Julia inverse } sphere { 0, 1.1 } pigment { rgb 0.7 } }
intersection { object { Julia inverse translate 2*x } sphere { 2*x, 1.1 } pigment { rgb 0.7 } }
