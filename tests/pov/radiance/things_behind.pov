// Balls and a beam seen through a cube: their outlines bend where the glass begins.
#include "clear_glass.inc"
camera { location <0.3, 0.4, -7> look_at 0 angle 26 right x*4/3 }
box { <-1, -0.8, -0.6>, <1, 0.8, 0.4> Plate(1.5) rotate y*10 }
sphere { <-0.8, 0.3, 1.5>, 0.5 pigment { rgb 0.9 } }
sphere { <0.7, -0.4, 2>, 0.6 pigment { rgb 0.5 } }
box { <-2, -0.9, 1>, <2, -0.7, 1.2> pigment { rgb 0.7 } rotate z*8 }
background { rgb 0.2 }
