// An emerald in a step cut, its colour by fading, under a soft box; radiosity as in a product shot.
#version 3.7;
#include "colors.inc"
#include "math.inc"
#include "transforms.inc"

#default { texture { finish { ambient 0 } } }

global_settings {
  assumed_gamma 1.0
  max_trace_level 25
  radiosity {
    pretrace_start 0.08
    pretrace_end   0.01
    count 20
    nearest_count 5
    error_bound 0.5
    recursion_limit 2
    low_error_factor 0.5
    gray_threshold 0
    minimum_reuse 0.015
    brightness 1
    adc_bailout 0.01/2
  }
}

camera {
  location <2, 6, -7>
  look_at <0, 0, 0>
  right x*image_width/image_height
  up y
  angle 36
  aperture 0.05
  blur_samples 20
  focal_point <0, 0.4, 0>
  confidence 0.95
  variance 1/200
}

// One row of facets all round, at this slope, touching the girdle's outline at this inset and height.
#macro Row(Slope, L, W, C, Inset, H)
  plane { y, 0 Reorient_Trans(y, <sind(Slope), cosd(Slope), 0>) translate <L - Inset, H, 0> }
  plane { y, 0 Reorient_Trans(y, <-sind(Slope), cosd(Slope), 0>) translate <-L + Inset, H, 0> }
  plane { y, 0 Reorient_Trans(y, <0, cosd(Slope), sind(Slope)>) translate <0, H, W - Inset> }
  plane { y, 0 Reorient_Trans(y, <0, cosd(Slope), -sind(Slope)>) translate <0, H, -W + Inset> }
  #local K = 0;
  #while (K < 4)
    plane {
      y, 0
      Reorient_Trans(y, <sind(Slope), cosd(Slope), 0>)
      rotate y*45
      translate <(L + W - C)/2, 0, -(L + W - C)/2> - Inset*<1, 0, -1>/sqrt(2) + H*y
      scale <(K < 2 ? 1 : -1), 1, (mod(K, 2) = 0 ? 1 : -1)>
    }
    #local K = K + 1;
  #end
#end

#declare Emerald_Shape = intersection {
  plane { y, 0.5 }
  Row(50, 1.4, 1, 0.3, 0, 0.05)
  Row(40, 1.4, 1, 0.3, 0.15, 0.05 + 0.15*tand(50))
  Row(90, 1.4, 1, 0.3, 0, 0)
  Row(180 - 52, 1.4, 1, 0.3, 0, -0.05)
  Row(180 - 44, 1.4, 1, 0.3, 0.3, -0.05 - 0.3*tand(52))
  Row(180 - 38, 1.4, 1, 0.3, 0.6, -0.05 - 0.3*tand(52) - 0.3*tand(44))
}

object {
  Emerald_Shape
  pigment { rgbf 1 }
  finish { specular 1 roughness 0.0005 reflection { 0.02, 1 fresnel } conserve_energy }
  interior {
    ior 1.58
    fade_distance 1
    fade_power 1001
    fade_color <0.1, 0.75, 0.4>
    media { absorption rgb <0.2, 0.02, 0.1> samples 1, 1 method 3 }
  }
  translate y*1.2
}

plane { y, 0 pigment { rgb <0.8, 0.8, 0.78> } finish { diffuse 0.7 } }
box {
  <-3, 0, -2>, <3, 0.1, 2>
  pigment { rgb 1 }
  finish { emission 2 diffuse 0 }
  rotate x*-30
  translate <0, 7, 4>
}
background { rgb <0.2, 0.22, 0.25> }
