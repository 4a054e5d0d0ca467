// A parallel view of direction, right and up.
#include "head.inc"
camera { orthographic location <0.5, 6, 0.5> direction -y right x*4 up z*3 }
object { Letter }
