// A wedge turns the wall's picture aside, and its mirrors show the sky.
#include "clear_glass.inc"
camera { location <0, 0.2, -8> look_at 0 angle 22 right x*4/3 }
intersection {
  plane { -z, 0.3 } plane { z, 0.3 rotate y*8 } plane { x, 1 } plane { -x, 1 } plane { y, 1 } plane { -y, 1 }
  Plate(1.6)
  rotate y*8
}
Checkered_Wall(3)
Even_Sky()
