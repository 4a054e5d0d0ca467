// Colours in every spelling, and by the names of colors.inc.
#include "head.inc"
#include "colors.inc"
camera { orthographic location <3.9, 1.3, -5> right x*8.2 up y*6 }
#macro Swatch(I, C) box { 0, <0.8, 0.6, 0.1> translate <mod(I, 8), 2 - 2*div(I, 8), 0> pigment { C } } #end
Swatch(0, rgb <1, 0.2, 0.1>)
Swatch(1, rgb 0.5)
Swatch(2, color red 0.3 green 0.7)
Swatch(3, color rgb <0.1, 0.2, 0.9>)
Swatch(4, rgb x + 0.5*y)
Swatch(5, rgb <0.2, 0.4, 0.6>*1.5)
Swatch(6, srgb <0.5, 0.25, 0.75>)
Swatch(7, Red)
Swatch(8, Gray60)
Swatch(9, MidnightBlue)
Swatch(10, Gold)
Swatch(11, rgb CHSV2RGB(<200, 0.6, 0.8>))
Swatch(12, Red*0.5 + Green*0.25)
Swatch(13, color SpringGreen)
Swatch(14, rgb <Orange.red, Orange.green, 1>)
Swatch(15, color rgbt <0.2, 0.8, 0.6, 0>)
