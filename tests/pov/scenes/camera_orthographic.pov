// A parallel view with its size in right and up.
#include "head.inc"
camera { orthographic location <3, 3, -5> right x*4 up y*3 look_at <0.5, 1, 0.3> }
object { Letter }
