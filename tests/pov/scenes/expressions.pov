// Things placed by functions: rotations of vectors, products, powers, conditions, random numbers.
#include "head.inc"
camera { location <0, 0, -10> angle 45 right x*4/3 }
#declare Dice = seed(7);
#for (I, 1, 20)
  sphere { <rand(Dice)*8 - 4, rand(Dice)*6 - 3, rand(Dice)>, 0.08 + 0.1*rand(Dice) pigment { rgb <1, 0.6, 0.2> } }
#end
#for (I, 0, 9)
  box { -0.12, 0.12 translate vrotate(<2.2, 0, 0>, <0, 0, I*36>) + vaxis_rotate(y, <1, 1, 0>, I*20)*0.4 pigment { rgb <0.2, 1, 0.5> } }
#end
sphere { vnormalize(vcross(<1, 2, 0>, <0, 1, -1>))*1.2, pow(0.5, 2) + (vlength(<3, 4, 0>) = 5 ? 0.1 : 0.5) pigment { rgb 1 } }
sphere { <select(-1, -2, 0, 2), max(0.1, 0.4, -3), int(1.9) - 1>, abs(sin(pi/6))*0.6 pigment { rgb <0, 0, 1> } }
