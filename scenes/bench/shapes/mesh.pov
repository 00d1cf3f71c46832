// A mesh of 20000 smooth triangles.
#include "stage.inc"
#declare N = 100;
#macro Pt(I, J)
  (1 + 0.15*sin(12*pi*I/N)*sin(8*pi*J/N))*<sin(pi*J/N)*cos(2*pi*I/N), cos(pi*J/N), sin(pi*J/N)*sin(2*pi*I/N)>
#end
#declare Ball = mesh {
  #for (I, 0, N - 1)
    #for (J, 0, N - 1)
      #local A = Pt(I, J); #local B = Pt(I + 1, J); #local C = Pt(I, J + 1); #local D = Pt(I + 1, J + 1);
      #if (J > 0) smooth_triangle { A, A, B, B, D, D } #end
      #if (J < N - 1) smooth_triangle { A, A, D, D, C, C } #end
    #end
  #end
}
Crowd(Ball)
