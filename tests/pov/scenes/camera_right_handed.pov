// A right-handed camera: its right is minus x.
#include "head.inc"
camera { location <1, 2, -5> right -x*4/3 look_at <0.5, 1, 0> angle 38 }
object { Letter }
