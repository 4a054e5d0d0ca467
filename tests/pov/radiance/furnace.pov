// A uniform room: whatever the glass does, every path ends at 0.5.
#include "clear_glass.inc"
camera { location <2, 3, -7> look_at 0 angle 35 right x*4/3 }
background { rgb 0.5 }
box { -1, 1 Glass(1.5) rotate <20, 30, 0> translate x*-1.3 }
intersection {
  plane { y, 0.8 } plane { -y, 0.8 }
  plane { x, 0.9 rotate z*30 } plane { -x, 0.9 rotate z*-20 }
  plane { z, 0.9 rotate x*-25 } plane { -z, 0.9 rotate x*15 }
  Glass(1.8)
  translate x*1.3
}
