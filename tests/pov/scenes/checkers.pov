// A checker on a floor and on a turned box, scaled and moved after it was applied.
#include "head.inc"
camera { location <1, 3, -6> look_at <0, 0.6, 0> angle 45 right x*4/3 }
plane { y, 0 pigment { checker rgb 0.9, rgb <0.1, 0.1, 0.4> scale 1.3 rotate y*25 translate x*0.3 } }
box {
  <-0.8, 0.2, -0.8>, <0.8, 1.8, 0.8>
  pigment { checker rgb <1, 0.3, 0>, rgb <0, 0.5, 0.2> scale 0.7 }
  rotate y*35
}
