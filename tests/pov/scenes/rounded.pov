// Things of shapes.inc: a rounded box, rods along a box's edges, balls joined by a cone.
#include "head.inc"
#include "shapes.inc"
camera { location <1, 3, -9> look_at <0, 0.1, 0> angle 40 right x*4/3 }
object { Round_Box(<-3.4, -0.8, -0.8>, <-1.6, 0.8, 0.8>, 0.3, no) pigment { rgb <1, 0.2, 0> } }
object { Wire_Box(<-0.7, -0.7, -0.7>, <0.9, 0.9, 0.7>, 0.1, no) pigment { rgb <0, 1, 0.4> } }
object { Connect_Spheres(<1.7, -0.6, 0>, 0.5, <2.6, 0.8, 0.4>, 0.2) pigment { rgb <0.1, 0.3, 1> } }
object { Round_Cone3(<2.6, -0.9, 0>, 0.2, <3.4, 0, 0>, 0.4, no) pigment { rgb <1, 1, 0> } }
object { Spheroid(<0, -1.4, 0>, <1, 0.2, 0.4>) pigment { rgb 1 } }
