// A matrix: shear, mirror, and a turn; its last row moves.
#include "head.inc"
camera { location <0, 0, -12> angle 36 right x*4/3 }
object { Letter matrix <1, 0, 0, 0.4, 1, 0, 0, 0, 1, -3, 0.2, 0> }
object { Letter matrix <0, 1, 0, -1, 0, 0, 0, 0, 1, 0.5, 0, 1> }
object { Letter matrix <1, 0.2, 0, 0, 1, 0.5, 0.3, 0, -1, 1.5, -1, 0> }
