// Boxes with corners given in any order.
#include "head.inc"
camera { location <2, 4, -9> look_at 0 angle 40 right x*4/3 }
box { <-3, -1, -1>, <-1.5, 1, 1> pigment { rgb <1, 0.2, 0> } }
box { <1, 1, 1>, <-0.5, -1, -1> pigment { rgb <0, 1, 0.4> } rotate y*30 }
box { <3, -0.5, 0.5>, <2, 1.5, -0.5> pigment { rgb <0.1, 0.3, 1> } rotate z*-20 }
