// A polynomial of degree 6 over a floor that shows its shadow.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.3, -4> look_at 0 angle 45 }
light_source { <3, 5, -6>, rgb 1 }
polynomial { 6, xyz(6, 0, 0): 1, xyz(0, 6, 0): 1, xyz(0, 0, 6): 1, xyz(2, 2, 0): -0.8, xyz(0, 0, 0): -0.35 sturm rotate <20, 30, 0> pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 } }
plane { y, -1.1 pigment { rgb 0.8 } }
