// #for, #while and #if: a ring, and a row that thins out.
#include "head.inc"
camera { location <0, 5, -9> look_at <0, 0.2, 0> angle 42 right x*4/3 }
#for (I, 0, 11)
  box { -0.2, 0.2 scale <1, 1 + I/4, 1> rotate y*10*I translate x*3 rotate y*I*360/12 pigment { rgb <1, I/12, 0.2> } }
#end
#declare K = 0;
#while (K < 5)
  #if (mod(K, 2) = 0) sphere { <K - 2, 0.3, 0>, 0.3 pigment { rgb 1 } }
  #else box { -0.25, 0.25 translate <K - 2, 0.3, 0> pigment { rgb <0, 0.7, 1> } } #end
  #declare K = K + 1;
#end
