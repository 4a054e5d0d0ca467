// Planes: a floor, a wall by its normal and distance, and a plane that was moved.
#include "head.inc"
camera { location <1, 2, -7> look_at <0, 1, 0> angle 60 right x*4/3 }
plane { y, -1 pigment { rgb <0.2, 0.4, 0> } }
plane { <1, 0, 2>, 6 inverse pigment { rgb <0.5, 0, 0.1> } }
plane { x, 0 rotate z*-20 translate x*-4 pigment { rgb <0, 0.1, 0.6> } }
