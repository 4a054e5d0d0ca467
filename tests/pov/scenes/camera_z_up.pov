// A camera for scenes with z up.
#include "head.inc"
camera { location <4, -5, 3> sky z up z right x*4/3 look_at <0.5, 0, 1> angle 35 }
object { Letter rotate x*90 }
