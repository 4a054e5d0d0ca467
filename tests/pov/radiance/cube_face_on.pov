// A cube seen along its normal, before a wall that shines: two faces, all at normal incidence.
#include "clear_glass.inc"
camera { orthographic location <0, 0, -5> right x*4 up y*3 }
box { <-1, -1, -1>, <1, 1, 1> Plate(1.5) }
Checkered_Wall(4)
