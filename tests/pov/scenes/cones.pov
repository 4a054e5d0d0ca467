// Cones and cut cones.
#include "head.inc"
camera { location <1, 3, -9> look_at 0 angle 40 right x*4/3 }
cone { <-2.5, -1, 0>, 1, <-2.5, 1.2, 0.5>, 0 pigment { rgb <1, 0.2, 0> } }
cone { <0, -1, 0>, 0.3, <0, 1, 0>, 0.8 open pigment { rgb <0, 1, 0.4> } rotate x*-35 }
cone { 0, 0.2, x, 0.7 scale <1, 1.4, 1> rotate z*30 translate x*2 pigment { rgb <0.1, 0.3, 1> } }
