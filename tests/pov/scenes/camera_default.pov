// The camera that a scene without one has, moved back by its location alone.
#include "head.inc"
camera { location <0.3, 0.8, -4> }
object { Letter }
