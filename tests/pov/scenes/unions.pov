// Unions within unions: pigments pass down, transforms pile up.
#include "head.inc"
camera { location <0, 1.5, -9> look_at <0, 0.5, 0> angle 40 right x*4/3 }
#declare Pair = union { sphere { x*-0.6, 0.5 } box { <0.2, -0.5, -0.5>, <1, 0.5, 0.5> pigment { rgb <0, 0.6, 1> } } }
union {
  object { Pair }
  object { Pair rotate z*90 translate <2.5, 0.6, 0> pigment { rgb <0.3, 1, 0.2> } }
  union { object { Pair scale 0.6 } translate <-2.2, 1, 0> }
  pigment { rgb <1, 0.5, 0.1> }
  rotate <10, 20, 5>
}
