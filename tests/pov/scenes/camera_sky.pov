// A camera that leans, by its sky.
#include "head.inc"
camera { location <3, 2, -4> sky <0.4, 1, 0.2> look_at <0.4, 1, 0.2> angle 40 right x*4/3 up y }
object { Letter }
