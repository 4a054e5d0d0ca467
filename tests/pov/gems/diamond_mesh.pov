// A brilliant as a triangle mesh, the way faceting programs export stones: many fans of triangles, six decimals.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 30 }

#include "diamond_mesh.inc"

#declare Ior = 2.417;

camera {
  perspective
  location <0, 2.4, -2.8>*1.6
  look_at  <0, -0.1, 0>
  angle    28
  right    x*image_width/image_height
}

background { color rgb <0.15, 0.17, 0.2> }

light_source { <10, 25, -12>, color rgb 1.1 }
light_source { <-15, 10, -5>, color rgb 0.4 shadowless }

// A lamp to be seen in the facets.
sphere {
  <0, 0, 0>, 1.2
  scale <3, 0.2, 3>
  translate <-4, 9, 3>
  hollow
  no_shadow
  pigment { color rgb 1 }
  finish { ambient 2 diffuse 0 }
}

object {
  Geometry
  texture {
    pigment { color rgbt <1, 1, 1, 1> }
    finish { phong 0.9 phong_size 120 reflection { 1 fresnel } conserve_energy }
  }
  interior { ior Ior caustics 1 }
  rotate y*11
}
