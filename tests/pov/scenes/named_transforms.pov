// The transforms of transforms.inc.
#include "head.inc"
#include "transforms.inc"
camera { location <0, 0, -14> angle 36 right x*4/3 }
object { Letter Axis_Rotate_Trans(<1, 2, 1>, 50) translate <-4, 0, 0> }
object { Letter Reorient_Trans(y, <1, 1, -1>) translate <-1.5, 0, 0> }
object { Letter Rotate_Around_Trans(<0, 0, 90>, <1, 1, 0>) translate <0.5, 0.2, 0> }
object { Letter Point_At_Trans(<1, 0.5, -0.3>) translate <1, -2, 0> }
object { Letter Axial_Scale_Trans(<1, 1, 0>, 1.7) translate <2, 0.3, 0> scale 0.8 }
object { Letter Shear_Trans(<1, 0.2, 0>, <0, 1, 0.4>, z) scale 0.6 translate <-1.5, -2.2, 0> }
sphere { vtransform(<1, 1, 0>, transform { Axis_Rotate_Trans(z, 40) translate <2, -1, 0> }), 0.3 pigment { rgb 1 } }
