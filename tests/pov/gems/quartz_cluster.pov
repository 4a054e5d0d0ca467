// Quartz crystals on a dark table: a macro per crystal, chance, spotlights, fog and a normal on the table.
#version 3.7;
#include "colors.inc"
#include "shapes.inc"

global_settings { assumed_gamma 1 max_trace_level 15 charset utf8 }

camera { location <0, 5, -9> look_at <0, 1, 0> angle 32 right x*image_width/image_height }

light_source {
  <8, 12, -6> color White*1.3
  spotlight point_at <0, 1, 0> radius 20 falloff 35 tightness 2
  area_light x*2, y*2, 3, 3 adaptive 1 jitter
  fade_distance 14 fade_power 2
}
light_source { <-9, 6, -4> color rgb <0.5, 0.6, 0.9> fade_distance 9 fade_power 2 media_attenuation off }

fog { fog_type 1 distance 200 color rgb <0.7, 0.75, 0.8> }

sky_sphere {
  pigment { gradient y color_map { [0 color rgb <0.05, 0.05, 0.07>] [1 color rgb <0.5, 0.55, 0.6>] } scale 2 translate -1 }
}

#declare Seed = seed(11);

#macro Crystal(Radius, Height)
  intersection {
    #local I = 0;
    #while (I < 6)
      plane { x, Radius*(0.9 + 0.2*rand(Seed)) rotate y*60*I }
      plane { x, Radius*0.6 rotate z*38 translate y*Height rotate y*60*I }
      #local I = I + 1;
    #end
    plane { -y, 0 }
    plane { y, Height*1.6 }
  }
#end

#declare T_Clear = texture {
  pigment { color rgbf <0.98, 0.98, 0.98, 0.95> }
  normal { bumps 0.02 scale 0.3 }
  finish { phong 1 phong_size 200 reflection 0.1 }
};
#declare I_Clear = interior { ior 1.544 };

#declare N = 0;
#while (N < 5)
  object {
    Crystal(0.35 + 0.15*rand(Seed), 1 + rand(Seed))
    texture { T_Clear }
    interior { I_Clear }
    rotate z*(8*N - 16)
    translate <1.3*N - 2.6, 0.4, 0.8*sin(N)>
  }
  #declare N = N + 1;
#end

plane {
  y, 0
  texture {
    pigment { color rgb <0.25, 0.2, 0.18> }
    normal { granite 0.1 }
    finish { diffuse 0.8 specular 0.2 ambient 0.05 }
  }
}
