// A scene as they were written for version 3.1: colour words, ambient light, a glass box and a water-clear prism.
#version 3.1;
#include "colors.inc"
#include "shapes.inc"

global_settings { max_trace_level 12 assumed_gamma 2.2 }

camera {
   location  <0, 2.5, -7>
   up        <0, 1, 0>
   right     <4/3, 0, 0>
   direction <0, 0, 1.6>
   look_at   <0, 0.7, 0>
}

light_source { <-30, 50, -40> colour red 0.7 green 0.7 blue 0.7 }
light_source { <40, 20, -30> colour rgb 0.3 }

#declare Glass_Look = texture {
   pigment { colour red 1.0 green 1.0 blue 1.0 filter 1.0 }
   finish { ambient 0 diffuse 0 reflection 0.1 phong 0.3 phong_size 60 }
}

box {
   <-1, 0, -0.6>, <1, 1.4, 0.6>
   texture { Glass_Look }
   interior { ior 1.5 caustics 0.8 }
   rotate y*25
   translate x*-1.3
}

intersection {
   plane { -z, 0.5 }
   plane { x, 0.45 rotate y*-30 }
   plane { -x, 0.45 rotate y*30 }
   plane { y, 1.6 }
   plane { y, 0 inverse }
   texture { Glass_Look }
   interior { ior 1.6 }
   translate x*1.5
}

plane {
   y, 0
   pigment { checker colour Wheat colour Brown scale 0.75 }
   finish { ambient 0.2 diffuse 0.8 }
}

sphere { <0, 0.4, 2>, 0.4 pigment { colour SkyBlue } finish { phong 0.8 ambient 0.15 } }

background { colour rgb <0.06, 0.1, 0.25> }
