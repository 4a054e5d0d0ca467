// Discs, whole and with a hole.
#include "head.inc"
camera { location <1, 3, -9> look_at 0 angle 40 right x*4/3 }
disc { <-2, 0, 0>, <1, 1, -1>, 1 pigment { rgb <1, 0.2, 0> } }
disc { <0.5, 0, 0>, y, 1.2, 0.5 pigment { rgb <0, 1, 0.4> } }
disc { 0, z, 0.8, 0.3 scale <1, 1.5, 1> rotate y*40 translate x*2.6 pigment { rgb 1 } }
