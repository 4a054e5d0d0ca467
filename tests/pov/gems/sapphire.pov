// A sapphire on a checkered floor: a stone of planes, an area light, photons, reflection and dispersion.
#version 3.7;
#include "colors.inc"
#include "ior.inc"

global_settings {
  assumed_gamma 1.0
  max_trace_level 20
  adc_bailout 1/255
  ambient_light rgb <1, 1, 1>
  photons { count 5000 autostop 0 jitter .4 }
}

camera {
  location  <0.0, 3.2, -5.0>
  direction 1.5*z
  right     x*image_width/image_height
  look_at   <0.0, 0.4, 0.0>
}

sky_sphere {
  pigment {
    gradient y
    color_map {
      [0.0 rgb <0.6, 0.7, 1.0>]
      [0.7 rgb <0.0, 0.1, 0.8>]
    }
  }
}

light_source {
  <0, 0, 0>
  color rgb <1, 1, 1>*1.2
  area_light <4, 0, 0>, <0, 0, 4>, 5, 5
  adaptive 1
  jitter
  circular orient
  translate <-20, 30, -20>
  photons { reflection on refraction on }
}

plane {
  y, -0.9
  pigment { checker color White, color Gray30 scale 0.8 }
  finish { ambient 0.1 diffuse 0.7 reflection 0.05 phong 0.2 phong_size 40 }
  photons { pass_through }
}

#declare Sides = 8;
#declare Step = 360/Sides;

#declare Stone =
intersection {
  plane { y, 0.42 }
  #declare I = 0;
  #while (I < Sides)
    plane { x, 1 rotate y*(I + 0.5)*Step }
    plane { y, 0 rotate z*-34.5 translate x*1 + y*0.06 rotate y*I*Step }
    plane { -y, 0 rotate z*41 translate x*1 - y*0.03 rotate y*I*Step }
    #declare I = I + 1;
  #end
  bounded_by { box { <-1.2, -1, -1.2>, <1.2, 0.5, 1.2> } }
}

#declare M_Stone =
material {
  texture {
    pigment { rgbf <0.85, 0.9, 1.0, 0.98> }
    finish { ambient 0 diffuse 0 specular 0.7 roughness 0.001 reflection { 0.0, 1.0 fresnel on } conserve_energy }
  }
  interior {
    ior iorSapphire
    dispersion dispSapphire
    dispersion_samples 12
    caustics 1.0
    fade_distance 1.5
    fade_power 1001
    fade_color rgb <0.15, 0.3, 0.9>
  }
}

object {
  Stone
  material { M_Stone }
  photons { target reflection on refraction on collect off }
  rotate y*12
  rotate x*-8
}
