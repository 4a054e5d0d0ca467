// Transforms by name, one within another, and backwards.
#include "head.inc"
camera { location <0, 0, -12> angle 36 right x*4/3 }
#declare Lean = transform { rotate z*30 translate <1, 0.5, 0> }
#declare Both = transform { Lean scale <1, 1.3, 1> }
object { Letter transform Lean translate x*-3.5 }
object { Letter transform { Lean inverse } translate <-0.5, -1, 0> }
object { Letter transform { Both } translate <0.5, -1.5, 0> }
object { Letter transform Both transform { Both inverse } scale 0.7 translate <3, 0.5, 0> }
