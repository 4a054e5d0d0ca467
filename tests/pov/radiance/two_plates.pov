// Two plates of different glass one behind the other, seen along their normal: light bounces between them.
#include "clear_glass.inc"
camera { orthographic location <0, 0, -5> right x*4 up y*3 }
box { <-1.2, -1, -1>, <0.6, 1, -0.5> Plate(1.5) }
box { <-0.6, -0.8, 0>, <1.2, 0.8, 0.5> Plate(2.4) }
Checkered_Wall(4)
