#version 3.7;
#include "print.inc"
#include "math.inc"
#declare A=array[7]{3,1,4,1,5,9,2}
#declare AV=array[2]{<1,2,3>,<3,4,8>}
#declare PF_=Mean(A); PF("mean",PF_) #declare PV_=Mean(AV); PV("meanv",PV_) #declare PF_=Std_Dev(A,Mean(A)); PF("std",PF_) GetStats(A) 
#declare PF_=dimension_size(StatisticsArray,1); PF("sd",PF_) #declare i=0; #while(i<dimension_size(StatisticsArray,1)) #declare PF_=StatisticsArray[i]; PF("st",PF_) #declare i=i+1; #end
#declare i=-3; #while(i<=3)
 #declare PF_=Interpolate(i/3,-1,2,5,9,0); PF("ip0",PF_) #declare PF_=Interpolate(i,-1,2,5,9,1); PF("ip1",PF_)  #declare PF_=Interpolate(abs(i)/3,0,1,5,9,2); PF("ip2",PF_) #declare PF_=Interpolate(abs(i)/3,0,1,5,9,.5); PF("ip.5",PF_) 
 #if(i!=0) #declare PF_=Interpolate(abs(i)/3,0,1,5,9,-1); PF("ip-1",PF_) #declare PF_=Interpolate(abs(i)/3,0,1,5,9,-2); PF("ip-2",PF_) #end
 #declare PF_=even(i); PF("even",PF_) #declare PF_=odd(i); PF("odd",PF_) #declare PF_=sind(i*20); PF("sind",PF_) #declare PF_=cosd(i*20); PF("cosd",PF_) #declare PF_=tand(i*20); PF("tand",PF_) #declare PF_=asind(i/3); PF("asind",PF_) #declare PF_=acosd(i/3); PF("acosd",PF_) #declare PF_=atand(i); PF("atand",PF_) 
 #if(i!=0) #declare PF_=atan2d(i,2-i); PF("atan2d",PF_) #end
 #declare PF_=sgn(i); PF("sgn",PF_) #declare PF_=max3(i,1,-2); PF("max3",PF_) #declare PF_=min3(i,0,-2); PF("min3",PF_) #declare PF_=f_sqr(i); PF("fsqr",PF_) #declare PF_=clip(i,-1,2); PF("clip",PF_) #declare PF_=clamp(i,-1,2); PF("clamp",PF_) #declare PF_=clamp(i*1.3,0.5,2); PF("clamp2",PF_) #declare PF_=adj_range(i,2,5); PF("ar",PF_) #declare PF_=adj_range2(i,-1,2,4,9); PF("ar2",PF_)
 #declare i=i+.5; #end
#declare PF_=even(4); PF("even",PF_) #declare PF_=odd(7); PF("odd",PF_) #declare PF_=even(-7); PF("even",PF_) #declare PF_=odd(-7); PF("even",PF_) 
#declare V=<1,-2,3.5>; #declare W=<.3,.8,-.4>; #declare C=<1,2,3,4,5>;
#declare PV_=VSqr(V); PV("VSqr",PV_) #declare PV_=VPow(<1,2,3>,1.5); PV("VPow",PV_) #declare PF_=VEq(V,W); PF("VEq",PF_) #declare PF_=VEq(V,V); PF("VEq",PF_) #declare PF_=VZero(V); PF("VZ",PF_) #declare PF_=VZero(<0,0,0>); PF("VZ",PF_) #declare PF_=VLength5D(C); PF("VL5",PF_) #declare PC_=VNormalize5D(C); PC("vn5",PC_) #declare PF_=VDot5D(C,C); PF("vd5",PF_) #declare PF_=VEq5D(C,C); PF("veq5",PF_) #declare PF_=VZero5D(C); PF("vz5",PF_) #declare PC_=VPow5D(C,2); PC("vp5",PC_)
#declare PF_=VCos_Angle(V,W); PF("vca",PF_) #declare PF_=VAngle(V,W); PF("va",PF_) #declare PF_=VAngleD(V,W); PF("vad",PF_) #declare PF_=VRotation(V,W,vcross(V,W)); PF("vr",PF_) #declare PF_=VRotation(V,W,-vcross(V,W)); PF("vr",PF_) #declare PF_=VRotationD(V,W,vcross(V,W)); PF("vrd",PF_)#declare PF_=VRotationD(V,W,<0,0,0>); PF("vrd",PF_) #declare PF_=VDist(V,W); PF("vdist",PF_)
#declare R=seed(2); #declare i=0; #while(i<40) #declare P=<rand(R)-.5,rand(R)-.5,rand(R)-.5>; #declare PV_=VPerp_To_Vector(P); PV("perp",PV_) #declare i=i+1; #end
#declare PV_=VPerp_To_Vector(x); PV("perp",PV_) #declare PV_=VPerp_To_Vector(y); PV("perp",PV_) #declare PV_=VPerp_To_Vector(z); PV("perp",PV_) #declare PV_=VPerp_To_Vector(-x); PV("perp",PV_) #declare PV_=VPerp_To_Vector(x+y); PV("perp",PV_) #declare PV_=VPerp_To_Vector(y+z); PV("perp",PV_) #declare PV_=VPerp_To_Vector(x+z); PV("perp",PV_) #declare PV_=VPerp_To_Vector(x+y+z); PV("perp",PV_) #declare PV_=VPerp_To_Vector(x-y); PV("perp",PV_)
#declare PV_=VPerp_To_Plane(V,W); PV("pp",PV_) #declare PV_=VPerp_Adjust(V,W); PV("pa",PV_) #declare PV_=VProject_Plane(V,W); PV("vpp",PV_) #declare PV_=VProject_Axis(V,W); PV("vpa",PV_) #declare PF_=VMin(V); PF("vmin",PF_) #declare PF_=VMax(V); PF("vmax",PF_) #declare PV_=VWith_Len(V,3); PV("vwl",PV_)
#declare F=function(x,y,z){x*x*y+sin(z)*x}
#declare G=function(x,y,z){y*z-x}
#declare H=function(x,y,z){z*z*x*y}
#declare f1=fn_Gradient(F) #declare PF_=f1(1,2,3); PF("fg",PF_) #declare f2=fn_Gradient_Directional(F,W) #declare PF_=f2(1,2,3); PF("fgd",PF_) #declare f3=fn_Divergence(F,G,H) #declare PF_=f3(1,2,3); PF("fd",PF_)
#declare PV_=vGradient(F,V); PV("vg",PV_) #declare PV_=vCurl(F,G,H,V); PV("vc",PV_) #declare PF_=Divergence(F,G,H,V); PF("dv",PF_) #declare PF_=Gradient_Length(F,V); PF("gl",PF_) #declare PF_=Gradient_Directional(F,V,W); PF("gd",PF_)
SetGradientAccuracy(.1) #declare PV_=vGradient(F,V); PV("vg",PV_) #declare PF_=__Gradient_Fn_Accuracy_; PF("acc",PF_)
#declare f9=fn_Gradient(F) #declare PF_=f9(1,2,3); PF("fg",PF_)
#declare PF_=version; PF("ver",PF_)
