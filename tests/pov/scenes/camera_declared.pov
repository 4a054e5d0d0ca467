// A camera by name, moved.
#include "head.inc"
#declare Eye = camera { location <3, 2, -5> look_at <0.5, 1, 0> angle 30 right x*1.2 up y*1.1 }
camera { Eye rotate y*25 translate <0.2, 0.4, 0> }
object { Letter }
