// A perspective camera with look_at and angle.
#include "head.inc"
camera { location <2, 3, -5> look_at <0.5, 1, 0> angle 35 right x*image_width/image_height }
object { Letter }
