#version 3.7;
#include "print.inc"
#include "arrays.inc"
#include "strings.inc"
#include "colors.inc"
#macro PA(N,A) #local i=0; #while(i<dimension_size(A,1)) #declare PF_=A[i]; PF(concat(N,str(i,0,0)),PF_) #local i=i+1; #end #end
#declare A=array[7]{3,1,4,1,5,9,2}
#declare B=A; Sort_Array(B) PA("sort",B)
#declare B=A; Sort_Partial_Array(B,1,4) PA("part",B)
#declare B=A; Reverse_Array(B) PA("rev",B)
#declare B=A; Resize_Array(B,4) PA("res4",B)
#declare B=A; Resize_Array(B,9) #declare PF_=dimension_size(B,1); PF("dim",PF_) #declare PF_=defined(B[8]); PF("def",PF_) #declare PF_=B[6]; PF("b6",PF_)
#declare B=array[300]; #declare S=seed(3); #declare i=0; #while(i<300) #declare B[i]=rand(S); #declare i=i+1; #end
Sort_Array(B) PA("big",B)
#declare D3=array[2][2][3]{{{0,1,0.5},{0.25,.1,.2}},{{.3,.4,.6},{.7,.8,2}}}
#declare PS_=CRGBStr(rgb<.1,.2,.3>,0,3); PS("crgb",PS_) #declare PS_=CRGBFTStr(rgbft<.1,.2,.3,.4,.5>,6,2); PS("crgbft",PS_)
#declare PS_=Str(1/3); PS("Str",PS_) #declare PS_=VStr2D(<1,2.5>); PS("V2",PS_) #declare PS_=VStr(<1,2,1/3>); PS("V3",PS_) #declare PS_=Vstr2D(<1,2>,6,2); PS("v2",PS_) #declare PS_=Vstr(<1,2,3>,-7,3); PS("v3",PS_)
#declare PS_=Triangle_Str(x,y,z); PS("tri",PS_) #declare PS_=Smooth_Triangle_Str(x,x,y,y,z,z); PS("stri",PS_)
#declare i=-30; #while (i<420) #declare PV_=CH2RGB(i); PV(concat("CH2RGB",str(i,0,0)),PV_) #declare PC_=CHSL2RGB(<i,.3,.7,.1,.2>); PC("hsl",PC_) #declare PC_=CHSL2RGB(<i,1,.3>); PC("hsl2",PC_)  #declare PC_=CHSV2RGB(<i,.3,.7,.1,.2>); PC("hsv",PC_) #declare i=i+37; #end
#declare S=seed(9); #declare i=0; #while(i<30) #declare C=<rand(S),rand(S),rand(S),.1,.2>; #declare PC_=C; PC("c",PC_) #declare PC_=CRGB2HSL(C); PC("2hsl",PC_) #declare PC_=CRGB2HSV(C); PC("2hsv",PC_) #declare i=i+1; #end
#declare PC_=CRGB2HSL(rgb 1); PC("w",PC_) #declare PC_=CRGB2HSL(rgb 0); PC("b",PC_) #declare PC_=CRGB2HSV(rgb 0); PC("b",PC_) #declare PC_=CRGB2HSV(rgb .5); PC("g",PC_) #declare PC_=CRGB2HSV(rgb<1,1,0>); PC("y",PC_) #declare PC_=CRGB2HSV(rgb<1,0,1>); PC("m",PC_) #declare PC_=CRGB2HSV(rgb<0,1,1>); PC("c",PC_) #declare PC_=CRGB2HSV(rgb<1,0,.1>); PC("r",PC_)
#declare PF_=CRGB2H(rgb<.2,.5,.1>,.5,.4); PF("h",PF_)
#declare PF_=version; PF("ver",PF_)
