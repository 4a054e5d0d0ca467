// A fisheye.
#include "head.inc"
camera { fisheye location <0.5, 1, -1.6> look_at <0.5, 1, 0> angle 150 right x*4/3 up y }
object { Letter }
plane { y, -1 pigment { checker rgb 0.8, rgb <0, 0.2, 0.4> } }
plane { -z, -6 pigment { rgb <0.4, 0.1, 0> } }
