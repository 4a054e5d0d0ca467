// Cylinders, closed and open, and a turned one.
#include "head.inc"
camera { location <1, 3, -9> look_at 0 angle 40 right x*4/3 }
cylinder { <-3, -1, 0>, <-2.4, 1.2, 0.5>, 0.6 pigment { rgb <1, 0.2, 0> } }
cylinder { <0, -1, 0>, <0, 1, 0>, 0.7 open pigment { rgb <0, 1, 0.4> } rotate x*-35 }
cylinder { 0, x, 0.4 scale <1, 2, 1> rotate z*30 translate x*2 pigment { rgb <0.1, 0.3, 1> } }
