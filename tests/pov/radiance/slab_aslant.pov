// A slab at 15 degrees shifts the wall behind it.
#include "clear_glass.inc"
camera { location <0, 0, -6> look_at 0 angle 24 right x*4/3 }
box { <-0.9, -0.8, -0.25>, <0.9, 0.8, 0.25> Plate(1.5) rotate <6, 14, 0> }
Checkered_Wall(3)
