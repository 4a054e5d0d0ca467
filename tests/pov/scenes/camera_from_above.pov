// Straight down along the sky: right decides how the picture lies.
#include "head.inc"
camera { location <0.5, 7, 0.3> look_at <0.5, 0, 0.3> angle 30 right x*4/3 }
object { Letter }
