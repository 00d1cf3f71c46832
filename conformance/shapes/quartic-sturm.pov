// A quartic: a torus by its coefficients, with sturm.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at 0 angle 55 }
light_source { <3, 5, -6>, rgb 1 }
#declare A = 1.2*1.2 + 0.4*0.4;
#declare B = 1.2*1.2 - 0.4*0.4;
quartic {
    <1, 0, 0, 0, 2, 0, 0, 2, 0, -2*A, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 2, 0, 2*B, 0, 0, 0, 0, 1, 0, -2*A, 0, B*B>
    sturm rotate <-50, 0, 20> pigment { rgb <0.75, 0.55, 0.35> } finish { phong 0.4 }
}
