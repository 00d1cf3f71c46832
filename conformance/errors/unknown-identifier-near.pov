// error[unknown-identifier] 3:25 Redish
#declare Reddish = rgb <1, 0.2, 0.2>;
sphere { 0, 1 pigment { Redish } }
