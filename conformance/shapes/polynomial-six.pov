// A polynomial of degree 6 given term by term: Barth's sextic without its rim.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
#declare T = (1 + sqrt(5))/2;
#declare T2 = T*T; #declare T4 = T2*T2;
polynomial { 6,
    xyz(4, 2, 0): 4*T4, xyz(0, 4, 2): 4*T4, xyz(2, 0, 4): 4*T4,
    xyz(2, 4, 0): -4*T2, xyz(0, 2, 4): -4*T2, xyz(4, 0, 2): -4*T2,
    xyz(2, 2, 2): 4*(T4*T2 - 1)*-1,
    xyz(4, 0, 0): -(1 + 2*T), xyz(0, 4, 0): -(1 + 2*T), xyz(0, 0, 4): -(1 + 2*T),
    xyz(2, 2, 0): -2*(1 + 2*T), xyz(0, 2, 2): -2*(1 + 2*T), xyz(2, 0, 2): -2*(1 + 2*T),
    xyz(2, 0, 0): 2*(1 + 2*T), xyz(0, 2, 0): 2*(1 + 2*T), xyz(0, 0, 2): 2*(1 + 2*T),
    xyz(0, 0, 0): -(1 + 2*T)
    sturm clipped_by { sphere { 0, 1.7 } } rotate <20, 30, 0> pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 }
}
