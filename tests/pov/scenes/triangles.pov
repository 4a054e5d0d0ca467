// Triangles by themselves, a mesh and a mesh2.
#include "head.inc"
camera { location <0.5, 2, -8> look_at <0.5, 0, 0> angle 42 right x*4/3 }
triangle { <-3, -1, 0>, <-1.6, -1, 0.5>, <-2, 1.2, 0> pigment { rgb <1, 0.2, 0> } }
mesh {
  triangle { <0, -1, 0>, <1, -1, 0>, <0.5, 0.8, 0.5> }
  triangle { <1, -1, 0>, <1.3, 0.5, 1>, <0.5, 0.8, 0.5> }
  pigment { rgb <0, 1, 0.4> }
  rotate z*10
}
mesh2 {
  vertex_vectors { 4, <2, -1, 0>, <3.4, -1, 0>, <3.4, 1, 0>, <2, 0.6, 1> }
  face_indices { 2, <0, 1, 2>, <0, 2, 3> }
  pigment { rgb <0.1, 0.3, 1> }
}
