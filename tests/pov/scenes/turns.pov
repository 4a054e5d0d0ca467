// rotate about x, then y, then z, by the left hand; and about one axis after the other.
#include "head.inc"
camera { location <0, 0, -12> angle 36 right x*4/3 }
object { Letter rotate <40, 30, 20> translate <-2.5, 0.5, 0> }
object { Letter rotate x*40 rotate y*30 rotate z*20 translate <0.5, 0.5, 0> }
object { Letter rotate z*20 rotate y*30 rotate x*40 translate <2, -2.5, 0> }
object { Letter rotate <0, 0, 90> rotate <0, -45, 0> translate <-1, -2.5, 0> }
