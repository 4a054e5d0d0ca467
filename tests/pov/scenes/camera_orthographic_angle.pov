// A parallel view as wide as a perspective one at what it looks at.
#include "head.inc"
camera { orthographic location <3, 1, -5> look_at <0.5, 1, 0.3> angle 35 right x*4/3 }
object { Letter }
