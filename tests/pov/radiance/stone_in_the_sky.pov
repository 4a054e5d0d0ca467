// A stone of planes under an even sky.
#include "clear_glass.inc"
camera { location <0, 6, -4> look_at 0 angle 22 right x*4/3 }
intersection {
  #for (I, 0, 7)
    plane { x, 0.9 rotate y*45*I }
    plane { x, 0.8 rotate z*35 rotate y*45*I }
    plane { x, 0.75 rotate z*-42 rotate y*45*I }
  #end
  plane { y, 0.42 }
  Glass(1.5)
}
Even_Sky()
