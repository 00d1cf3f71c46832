#version 3.7;
#include "print.inc"
#include "rand.inc"
#declare PF_=rand(RdmA); PF("A",PF_) #declare PF_=rand(RdmB); PF("B",PF_) #declare PF_=rand(RdmC); PF("C",PF_) #declare PF_=rand(RdmD); PF("D",PF_)
#declare S=seed(7);
#declare Obj=sphere{<1,2,3>,1}
#declare Spl=spline{linear_spline 0,<0,0,0> 1,<0,1,0> 2,<0,.5,0> 3,<0,0,0>}
#declare i=0; #while(i<12)
#declare PF_=Prob(.5,S); PF("Prob",PF_) #declare PF_=SRand(S); PF("SRand",PF_) #declare PF_=RRand(2,5,S); PF("RRand",PF_) #declare PV_=VRand(S); PV("VRand",PV_) #declare PV_=VRand_In_Box(<1,2,3>,<4,5,7>,S); PV("box",PV_)
#declare PV_=VRand_In_Sphere(S); PV("insph",PV_) #declare PF_=rand(S); PF("s",PF_) #declare PV_=VRand_On_Sphere(S); PV("onsph",PV_) #declare PF_=rand(S); PF("s",PF_) #declare PV_=VRand_In_Obj(Obj,S); PV("inobj",PV_) #declare PF_=rand(S); PF("s",PF_)
#declare PF_=Rand_Cauchy(1,2,S); PF("cauchy",PF_) #declare PF_=rand(S); PF("s",PF_) #declare PF_=Rand_Student(5,S); PF("student",PF_) #declare PF_=rand(S); PF("s",PF_) #declare PF_=Rand_Normal(1,2,S); PF("normal",PF_) #declare PF_=rand(S); PF("s",PF_) #declare PF_=Rand_Gauss(1,2,S); PF("gauss",PF_) #declare PF_=rand(S); PF("s",PF_)
 #declare PF_=rand(S); PF("s",PF_) #declare PF_=Rand_Gamma(2.5,1.5,S); PF("gamma",PF_) #declare PF_=rand(S); PF("s",PF_) #declare PF_=Rand_Gamma(.5,1.5,S); PF("gamma.5",PF_) #declare PF_=rand(S); PF("s",PF_) #declare PF_=Rand_Gamma(1,1.5,S); PF("gamma1",PF_) #declare PF_=rand(S); PF("s",PF_) #declare PF_=Rand_Gamma(3,1.5,S); PF("gamma3",PF_) #declare PF_=rand(S); PF("s",PF_) #declare PF_=Rand_Gamma(9,1.5,S); PF("gamma9",PF_) #declare PF_=rand(S); PF("s",PF_) #declare PF_=Rand_Beta(2,3,S); PF("beta",PF_) #declare PF_=rand(S); PF("s",PF_) #declare PF_=Rand_Chi_Square(4,S); PF("chi",PF_) #declare PF_=rand(S); PF("s",PF_) #declare PF_=Rand_F_Dist(3,4,S); PF("f",PF_) #declare PF_=rand(S); PF("s",PF_)
#declare PF_=Rand_Triangle(1,5,2,S); PF("tri",PF_) #declare PF_=rand(S); PF("s",PF_) #declare PF_=Rand_Erlang(2,3,S); PF("erl",PF_) #declare PF_=rand(S); PF("s",PF_) #declare PF_=Rand_Exp(2,S); PF("exp",PF_) #declare PF_=rand(S); PF("s",PF_) #declare PF_=Rand_Lognormal(1,2,S); PF("logn",PF_) #declare PF_=rand(S); PF("s",PF_) #declare PF_=Rand_Pareto(2,S); PF("pareto",PF_) #declare PF_=rand(S); PF("s",PF_) #declare PF_=Rand_Weibull(2,3,S); PF("wei",PF_) #declare PF_=rand(S); PF("s",PF_)
#declare PF_=Rand_Bernoulli(.3,S); PF("bern",PF_) #declare PF_=rand(S); PF("s",PF_) #declare PF_=Rand_Binomial(10,.3,S); PF("binom",PF_) #declare PF_=rand(S); PF("s",PF_) #declare PF_=Rand_Geo(.3,S); PF("geo",PF_) #declare PF_=rand(S); PF("s",PF_) #declare PF_=Rand_Poisson(3,S); PF("poi",PF_) #declare PF_=rand(S); PF("s",PF_)
#declare i=i+1; #end
#declare PF_=version; PF("ver",PF_)
