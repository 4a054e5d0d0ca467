// A macro that calls itself, with locals of its own, and one that yields a piece of an expression.
#include "head.inc"
camera { location <0.4, 1.9, -8> look_at <0.4, 1.9, 0> angle 40 right x*4/3 }
#macro Twice(A) (2*A) #end
#macro Branch(Depth, Size)
  #local Thin = Size/8;
  union {
    box { <-Thin, 0, -Thin>, <Thin, Size, Thin> pigment { rgb <1, Depth/4, 0.3> } }
    #if (Depth > 0)
      object { Branch(Depth - 1, Size*0.7) rotate z*35 translate y*Size }
      object { Branch(Depth - 1, Size*0.6) rotate z*-40 rotate y*30 translate y*Size }
    #end
  }
#end
object { Branch(4, Twice(0.7)) }
