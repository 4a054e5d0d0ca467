// translate, rotate and scale in every order.
#include "head.inc"
camera { location <0, 0, -14> angle 36 right x*4/3 }
object { Letter translate x rotate z*60 scale <1, 0.5, 1> translate <-3.5, 0, 0> }
object { Letter scale <1, 0.5, 1> rotate z*60 translate x translate <-1.5, 1, 0> }
object { Letter rotate z*60 translate x scale <1, 0.5, 1> translate <1, -2, 0> }
object { Letter scale <-1, 1, 1> rotate y*30 translate <2.5, 0, 0> }
object { Letter scale 0.5 scale <2, 1, 1> translate <-2.5, -2.5, 0> }
