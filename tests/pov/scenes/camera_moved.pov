// A camera that is transformed as a whole, after look_at.
#include "head.inc"
camera {
  location <0, 0, -6> look_at <0.5, 0.7, 0> angle 36 right x*4/3
  rotate <20, -35, 10>
  translate <0.2, 0.5, 0.3>
}
object { Letter }
