// #switch with cases, ranges and a fall through; arrays of arrays.
#include "head.inc"
camera { location <3, 1, -10> look_at <3, 1, 0> angle 40 right x*4/3 }
#declare Steps = array[2][4] {{0.3, 0.6, 0.9, 1.2}, {1, 0.8, 0.4, 0.2}};
#for (I, 0, 7)
  #switch (I)
    #case (0) #case (1) #declare C = rgb <1, 0, 0>; #break
    #range (2, 4) #declare C = rgb <0, 1, 0>; #break
    #case (5) #declare C = rgb <0, 0, 1>;
    #else #declare C = rgb <0, 0.5, 1>;
  #end
  box { <I*0.9 - 0.3, 0, 0>, <I*0.9 + 0.3, Steps[div(I, 4)][mod(I, 4)]*2, 0.5> pigment { C } }
#end
