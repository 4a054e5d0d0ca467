// A turned box under an even sky: refraction, total reflection, and what leaks at every facet.
#include "clear_glass.inc"
camera { location <0, 0.5, -8> look_at 0 angle 22 right x*4/3 }
box { -0.8, 0.8 Glass(1.3) rotate <15, 25, 0> }
Even_Sky()
