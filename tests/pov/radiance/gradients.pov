// Gentle gradients with colour maps that jump, on things that were scaled and turned.
#include "clear_glass.inc"
camera { location <0, 1, -7> look_at 0 angle 42 right x*4/3 }
#declare Map = color_map { [0 rgb 0.3] [0.5 rgb 0.45] [0.5 rgb 0.7] [1 rgb <0.6, 0.62, 0.64>] }
box { -1.5, 1.5 pigment { gradient y color_map { Map } scale 3 translate -1.5 } rotate y*30 translate x*-2 }
box { -1.4, 1.4 pigment { gradient <1, 1, 0> color_map { [0.2 rgb 0.4] [0.8 rgb 0.6] } scale 2.5 } rotate z*10 translate x*1.9 }
