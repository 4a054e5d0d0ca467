// Spheres, stretched and turned.
#include "head.inc"
camera { location <0, 3, -9> look_at 0 angle 40 right x*4/3 }
sphere { <-2.4, 0, 0>, 1 pigment { rgb <1, 0.2, 0> } }
sphere { 0, 1 scale <0.5, 1.4, 1> rotate z*30 pigment { rgb <0, 1, 0.4> } }
sphere { 0, 0.7 scale <2, 1, 0.3> rotate <10, 50, 20> translate x*2.4 pigment { rgb 1 } }
