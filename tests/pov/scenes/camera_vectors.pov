// A camera of direction, right and up, none of unit length, up not upright.
#include "head.inc"
camera { location <0.5, 1, -6> direction <0.1, 0, 2.5> right <1.2, 0.1, 0> up <-0.1, 0.9, 0> }
object { Letter }
