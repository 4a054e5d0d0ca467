// A stone that turns with the clock, in a ring of lamps; written for an animation, with text for the console.
#version 3.7;
#include "consts.inc"
#include "colors.inc"

global_settings { assumed_gamma 1 max_trace_level 20 ambient_light White }

#ifndef (Facets) #declare Facets = 12; #end
#declare Turn = 360*clock/Facets;
#debug concat("frame ", str(frame_number, 0, 0), " of ", str(final_frame, 0, 0), ", turned by ", str(Turn, 0, 2), "\n")

#declare Eye = <0, 4, -6>;
camera {
  location Eye
  up <0, 1, 0>
  right <image_width/image_height, 0, 0>
  direction z*FoV_30/2
  sky y
  look_at <0, 0.1, 0>
}

#declare Ring = union {
  #for (I, 0, 11)
    sphere {
      <5, 6, 0>, 0.6
      rotate y*(30*I + 15)
      pigment { color rgb 1 }
      finish { ambient 1 diffuse 0 }
    }
  #end
  no_shadow
}
object { Ring }

// Pavilion and crown as arrays of angle and distance.
#declare Angles = array[3] {38, 90, 138.5}
#declare Reach = array[3] {0.86, 1, 0.78}

#declare Gem =
  intersection {
    #for (I, 0, Facets - 1)
      #for (J, 0, dimension_size(Angles, 1) - 1)
        plane { vaxis_rotate(y, z, -Angles[J]), Reach[J] rotate y*360*(I + (J = 2 ? 0.5 : 0))/Facets }
      #end
    #end
    plane { y, 0.5 }
  }

object {
  Gem
  texture { pigment { Clear } finish { reflection { 0 1 fresnel } } }
  interior { ior Diamond_Ior dispersion Diamond_Dispersion }
  rotate y*Turn
}

light_source { Eye + <2, 6, 0>, rgb 0.8 parallel point_at o }
background { color Gray10 }
