// A matt floor under two lamps, one of which fades, and black things that cast shadows on it.
#include "clear_glass.inc"
camera { location <0, 5, -8> look_at <0, 0, 0.4> angle 36 right x*4/3 }
light_source { <-5, 8, -3>, rgb 0.6 }
light_source { <4, 5, -4>, rgb 0.5 fade_distance 6 fade_power 2 }
plane { y, 0 pigment { checker rgb 0.6, rgb 0.3 scale 1.5 } finish { emission 0 diffuse 0.8 } }
sphere { <-1.2, 0.8, 0>, 0.8 pigment { rgb 0 } }
box { <0.4, 0, -0.6>, <1.6, 1.4, 0.6> pigment { rgb 0 } rotate y*20 }
