#version 3.7;
#include "print.inc"
#include "transforms.inc"
#include "shapes.inc"
#declare V=<1,-2,3.5>; #declare W=<.3,.8,-.4>; #declare U=<-.5,.2,.9>;
#macro T3(N,T) #declare PV_=vtransform(<0,0,0>,transform{T}); PV(N,PV_) #declare PV_=vtransform(<1,0,0>,transform{T}); PV(N,PV_) #declare PV_=vtransform(<0,1,0>,transform{T}); PV(N,PV_) #declare PV_=vtransform(<0,0,1>,transform{T}); PV(N,PV_) #end
T3("shear",transform{Shear_Trans(V,W,U)}) T3("mat",transform{Matrix_Trans(V,W,U,<4,5,6>)}) T3("axs",transform{Axial_Scale_Trans(W,2.5)}) T3("axr",transform{Axis_Rotate_Trans(W,33)}) T3("ra",transform{Rotate_Around_Trans(<10,20,30>,V)})
T3("reo",transform{Reorient_Trans(V,W)}) T3("reo=",transform{Reorient_Trans(y,y)}) T3("reo-",transform{Reorient_Trans(y,-y)}) T3("reox-",transform{Reorient_Trans(x,-3*x)}) T3("reoz-",transform{Reorient_Trans(-z,2*z)}) T3("reo-V",transform{Reorient_Trans(V,-V)}) T3("pa",transform{Point_At_Trans(W)}) T3("pay",transform{Point_At_Trans(y)}) T3("pa-y",transform{Point_At_Trans(-y)}) T3("paz",transform{Point_At_Trans(z)}) T3("pax",transform{Point_At_Trans(x)}) T3("paz",transform{Point_At_Trans(-z)})T3("paV",transform{Point_At_Trans(V)})
#declare O=box{<1,2,3>,<5,7,9>}
T3("ce",transform{Center_Trans(O,x+z)}) T3("ce2",transform{Center_Trans(O,y)}) T3("al",transform{Align_Trans(O,x,V)}) T3("al",transform{Align_Trans(O,-y+z,V)}) T3("al",transform{Align_Trans(O,<-1,-1,-1>,V)})
#declare Spl=spline{natural_spline 0,<0,0,0> 1,<1,1,0> 2,<3,.5,1> 3,<4,0,3>}
T3("sp",transform{Spline_Trans(Spl,1.2,y,.1,.5)}) T3("sp",transform{Spline_Trans(Spl,.2,y,.3,0)}) T3("sp",transform{Spline_Trans(Spl,2,z,.05,1)})
#declare PV_=vtransform(V,transform{rotate 30*y translate x}); PV("vt",PV_) #declare PV_=vinv_transform(V,transform{rotate 30*y translate x}); PV("vit",PV_)
#declare P=<0,0,0>; #declare N=<0,0,0>; #declare PF_=Isect(-10*z,z,sphere{0,1},P); PF("is",PF_) #declare PV_=P; PV("p",PV_) 
#declare Sp=sphere{0,1} #declare PF_=Isect(-10*z,z,Sp,P); PF("is",PF_) #declare PV_=P; PV("p",PV_) #declare PF_=IsectN(-10*z+.3*x,z,Sp,P,N); PF("is",PF_) #declare PV_=P; PV("p",PV_) #declare PV_=N; PV("n",PV_) #declare PF_=Isect(-10*z+3*x,z,Sp,P); PF("is",PF_) #declare PV_=P; PV("p",PV_)
Extents(O,P,N) #declare PV_=P; PV("mn",PV_) #declare PV_=N; PV("mx",PV_)
#macro E(N,Ob) #declare PV_=min_extent(Ob); PV(N,PV_) #declare PV_=max_extent(Ob); PV(N,PV_) #end
#declare O2=Center_Object(O,x+y) E("co",O2) #declare O2=Align_Object(O,-x,V) E("ao",O2)
#declare PF_=Text_Space("timrom.ttf","Hello A",2,.1); PF("ts",PF_) #declare PF_=Text_Width("timrom.ttf","Hello A",2,.1); PF("tw",PF_) #declare PF_=Text_Space("timrom.ttf","A",1,0); PF("ts",PF_) #declare PF_=Text_Width("timrom.ttf","A",1,0); PF("tw",PF_) #declare PF_=Align_Left; PF("al",PF_) #declare PF_=Align_Right; PF("al",PF_) #declare PF_=Align_Center; PF("al",PF_)
#declare Grid=seed(1);
#macro IN(N,Ob,Mn,Mx) #local i=0; #local c=0; #local sm=0; #while(i<400) #local q=<rand(Grid),rand(Grid),rand(Grid)>*((Mx)-(Mn))+(Mn); #if(inside(Ob,q)) #local c=c+1; #local sm=sm+i*i; #end #local i=i+1; #end #declare PF_=c; PF(N,PF_) #declare PF_=sm; PF(N,PF_) E(N,Ob) #end
#declare o1=Wedge(40) IN("wedge",o1,-x-y-z,x+y+z) #declare o1=Wedge(140) IN("wedge",o1,-x-y-z,x+y+z) #declare o1=Wedge(-60) IN("wedge",o1,-x-y-z,x+y+z) #declare o1=Wedge(220) IN("wedge",o1,-x-y-z,x+y+z)
#declare o1=object{Spheroid(V,<1,2,.5>)} IN("sphd",o1,V-2,V+2)
#declare o1=object{Supertorus(1,.4,.3,.4,.001,1.5)} IN("sut",o1,-1.5,<1.5,1.5,1.5>)
#declare o1=object{Supertorus(1,.4,1,1,.001,.5)} IN("sut",o1,-1.5,<1.5,1.5,1.5>)
#declare o1=object{Supercone(-y,.3,.5,2*y,.8,.2)} IN("suc",o1,<-1,-1.2,-1>,<1,2.2,1>)
#declare o1=object{Supercone(<1,0,1>,.3,.5,<3,2,2>,.8,.2)} IN("suc",o1,<0,-1,0>,<4,3,3>)
#declare o1=object{Connect_Spheres(-x,.3,2*x+y,.8)} IN("cs",o1,<-1.5,-1,-1>,<3,2,1>)
#declare o1=object{Wire_Box(<-1,-1,-1>,<1,2,3>,.3,0)} IN("wb",o1,-1,<1,2,3>) #declare o1=object{Wire_Box(<1,2,3>,<-1,-1,-1>,.3,1)} IN("wb",o1,-1,<1,2,3>) #declare o1=object{Wire_Box_Union(<-1,-1,-1>,<1,1,1>,.2)} IN("wb",o1,-1,<1,1,1>) #declare o1=object{Wire_Box_Merge(<-1,-1,-1>,<1,1,1>,.2)} IN("wb",o1,-1,<1,1,1>)
#declare o1=object{Round_Box(<-1,-1,-1>,<1,2,3>,.6,0)} IN("rb",o1,-1,<1,2,3>) #declare o1=object{Round_Box_Union(<1,2,3>,<-1,-1,-1>,.6)} IN("rb",o1,-1,<1,2,3>) #declare o1=object{Round_Box_Merge(<-1,-1,-1>,<1,2,3>,.6)} IN("rb",o1,-1,<1,2,3>)
#declare o1=object{Round_Cylinder(-y,<1,2,.5>,1,.4,0)} IN("rc",o1,-2,<2,3,2>) #declare o1=object{Round_Cylinder_Merge(-y,y,1,.6)} IN("rc",o1,-1,<1,1,1>) #declare o1=object{Round_Cylinder_Union(-y,y,1,.6)} IN("rc",o1,-1,<1,1,1>)
#declare o1=object{Round_Cone(-y,1,2*y,.5,.2,0)} IN("rco",o1,<-1,-1,-1>,<1,2,1>) #declare o1=object{Round_Cone_Merge(<0,0,0>,.5,<1,1,0>,1,.2)} IN("rco",o1,-1,<2,2,1>) #declare o1=object{Round_Cone_Union(<0,0,0>,.5,<1,1,0>,1,.2)} IN("rco",o1,-1,<2,2,1>)
#declare o1=object{Round_Cone2(-y,1,2*y,.5,0)} IN("rc2",o1,-2,<2,3,2>) #declare o1=object{Round_Cone2_Merge(<0,0,0>,.3,<1,2,3>,.6)} IN("rc2",o1,-1,<2,3,4>)
#declare o1=object{Round_Cone3(-y,1,2*y,.5,0)} IN("rc3",o1,-2,<2,3,2>) #declare o1=object{Round_Cone3_Merge(<0,0,0>,.3,<1,2,3>,.6)} IN("rc3",o1,-1,<2,3,4>)
#declare o1=object{Bevelled_Text("timrom.ttf","AB",8,35,.05,.3,0,0)} IN("bt",o1,<0,0,-.1>,<1.4,.8,.4>)
#declare o1=object{Bevelled_Text("timrom.ttf","AB",5,25,.1,.3,0,1)} IN("bt",o1,<0,0,-.1>,<1.4,.8,.4>)
#declare o1=object{Circle_Text("timrom.ttf","Hello",.5,.02,.2,1.5,0,Align_Left,40)} IN("ct",o1,<-2,-2,-.1>,<2,2,.3>)
#declare o1=object{Circle_Text("timrom.ttf","Hello",.5,.02,.2,1.5,1,Align_Right,40)} IN("ct",o1,<-2,-2,-.1>,<2,2,.3>)
#declare o1=object{Circle_Text("timrom.ttf","Hello you",.5,0,.2,1.5,0,Align_Center,90)} IN("ct",o1,<-2,-2,-.1>,<2,2,.3>)
#declare o1=object{Circle_Text("timrom.ttf","Hello you",.5,0,.2,1.5,1,Align_Center,270)} IN("ct",o1,<-2,-2,-.1>,<2,2,.3>)
#declare fh=function(x,y,z){.5+.3*sin(x*7+y*2)*cos(z*3)}
#macro TR(N,Ob,Mn,Mx) #local i=0; #while(i<25) #local q=<rand(Grid),rand(Grid),rand(Grid)>*((Mx)-(Mn))+(Mn); #local d=<rand(Grid),rand(Grid),rand(Grid)>*((Mx)-(Mn))+(Mn)-q; #local nn=<0,0,0>; #declare PV_=trace(Ob,q,d,nn); PV(N,PV_) #declare PV_=nn; PV(N,PV_) #local i=i+1; #end E(N,Ob) #end
#declare o1=union{Quad(0*x,x,x+y,y)} TR("q",o1,-.3,<1,1,1>) #declare o1=mesh{Smooth_Quad(0*x,-z,x,-z+x,x+y,-z,y,y-z)} TR("sq",o1,-.3,<1,1,1>)
#declare o1=object{HF_Square(fh,1,0,<8,9>,0,"",<0,0,0>,<2,1,3>)} TR("hfs",o1,-.3,<2,1.5,3>)
#declare o1=object{HF_Square(fh,0,1,<8,9>,1,"",<0,0,0>,<2,1,3>)} TR("hfs",o1,-.3,<2,1.5,3>)
#declare o1=object{HF_Sphere(fh,1,1,<8,9>,1,"",<1,0,0>,1,.4)} TR("hfsp",o1,-.3,<2,1.5,3>)
#declare o1=object{HF_Sphere(fh,0,0,<8,9>,0,"",<1,0,0>,1,.4)} TR("hfsp",o1,-.3,<2,1.5,3>)
#declare o1=object{HF_Cylinder(fh,1,1,<8,9>,1,"",0,2*y,1,.4)} TR("hfc",o1,-.3,<2,1.5,3>)
#declare o1=object{HF_Cylinder(fh,0,0,<8,9>,0,"",x,2*y,1,.4)} TR("hfc",o1,-.3,<2,1.5,3>)
#declare o1=object{HF_Torus(fh,1,1,<8,9>,1,"",1,.4,.3)} TR("hft",o1,-1,<2,1.5,3>)
#declare o1=object{HF_Torus(fh,0,0,<8,9>,0,"",1,.4,.3)} TR("hft",o1,-1,<2,1.5,3>)
#declare PF_=version; PF("ver",PF_)
