// The words themselves, as data. Only words.cpp reads this.
#pragma once

#include <string_view>

namespace icespar::word_lists {

inline constexpr std::string_view transforms = "translate rotate scale matrix transform";
inline constexpr std::string_view modifiers =
    "pigment finish texture material interior translate rotate scale matrix transform";

struct BlockWords {
    std::string_view name, words;
    const std::string_view* modifiers;
};

inline constexpr BlockWords blocks[] = {
    {"scene",
     "global_settings camera light_source environment background sky_sphere plane box sphere "
     "cylinder cone disc triangle smooth_triangle mesh mesh2 sheet gem object union merge "
     "intersection",
     nullptr},
    {"global_settings",
     "assumed_gamma max_trace_level unit mm_per_unit mm cm m um in ambient_light", nullptr},
    {"camera",
     "perspective orthographic fisheye location look_at right up direction sky angle aperture "
     "focal_point blur_samples confidence variance analyser",
     &transforms},
    {"light_source",
     "area_light circular orient spotlight cylinder parallel point_at radius falloff tightness "
     "shadowless fade_distance fade_power illuminant blackbody spectrum gaussian",
     &transforms},
    {"environment",
     "uniform gradient image function iso cosine sc2 aset idealscope head lamps illuminant "
     "blackbody polarised spectrum gaussian",
     &transforms},
    {"polarised", "linear circular right left", nullptr},
    {"analyser", "linear circular right left", nullptr},
    {"lamps", "disc spectrum gaussian", nullptr},
    {"sheet", "polariser waveplate neutral axis", &transforms},
    {"background", "spectrum gaussian", nullptr},
    {"sky_sphere", "pigment", &transforms},
    {"color_map", "color_map colour_map spectrum gaussian", nullptr},
    {"colour_map", "color_map colour_map spectrum gaussian", nullptr},
    {"image_map", "png exr map_type once interpolate", nullptr},
    {"spectrum", "", nullptr},
    {"gaussian", "", nullptr},
    {"plane", "inverse", &modifiers},
    {"box", "inverse", &modifiers},
    {"sphere", "inverse", &modifiers},
    {"cylinder", "open inverse", &modifiers},
    {"cone", "open inverse", &modifiers},
    {"disc", "inverse", &modifiers},
    {"triangle", "inverse", &modifiers},
    {"mesh", "triangle smooth_triangle inverse", &modifiers},
    {"mesh2", "vertex_vectors normal_vectors face_indices inverse", &modifiers},
    {"smooth_triangle", "inverse", &modifiers},
    {"vertex_vectors", "", nullptr},
    {"normal_vectors", "", nullptr},
    {"face_indices", "", nullptr},
    {"gem", "cut hull box mesh mesh2 intersection design object scale_to width", &modifiers},
    {"object",
     "cut hull box intersection sphere plane cylinder cone disc triangle smooth_triangle mesh "
     "mesh2 gem object "
     "union merge sheet inverse",
     &modifiers},
    {"union",
     "plane box sphere cylinder cone disc triangle smooth_triangle mesh mesh2 gem object union "
     "merge intersection "
     "light_source sheet split_union",
     &modifiers},
    {"merge",
     "plane box sphere cylinder cone disc triangle smooth_triangle mesh mesh2 gem object union "
     "merge intersection",
     &modifiers},
    {"intersection", "plane box cut hull mesh mesh2 object intersection inverse", &modifiers},
    {"cut", "gear offset facet", &transforms},
    {"facet", "angle distance index every from name", nullptr},
    {"hull", "", &transforms},
    {"interior", "ior crystal dispersion fade_distance fade_power fade_color fade_colour", nullptr},
    {"crystal",
     "mineral colour color indices axis axes dispersion absorption rotation spectrum gaussian",
     nullptr},
    {"dispersion", "cauchy sellmeier abbe bg", nullptr},
    {"absorption", "ordinary extraordinary first second third spectrum gaussian", nullptr},
    {"sellmeier", "", nullptr},
    {"cauchy", "", nullptr},
    {"pigment",
     "checker grid line gradient color_map colour_map image_map spectrum gaussian pigment",
     &transforms},
    {"finish", "diffuse albedo emission ambient", nullptr},
    {"texture", "pigment finish", &transforms},
    {"#default", "pigment finish texture", nullptr},
    {"material", "texture interior", &transforms},
    {"transform", "inverse", &transforms},
};

/// Words that POV-Ray does not know, so that its scenes may have declared them.
inline constexpr std::string_view ours =
    "environment gem cut hull facet gear index every from name design scale_to crystal mineral "
    "indices axis "
    "uniform illuminant blackbody polarised linear left unit mm cm m um in grid line bg cauchy "
    "abbe ordinary extraordinary first second third axes rotation "
    "sellmeier spectrum gaussian exr sheet head image iso cosine sc2 aset idealscope lamps "
    "analyser "
    "polariser waveplate neutral";

/// Words that language.md promises for later; also unknown to POV-Ray.
inline constexpr std::string_view ours_later =
    "square triangular pavement tiling text_space transform_space ovus ambient_occlusion "
    "diffuse_exponent";

/// Functions here, macros of an include in POV-Ray, which a scene may bring along.
inline constexpr std::string_view macros_of_includes = "vtransform vinv_transform";

inline constexpr std::string_view values =
    "x y z t u v pi tau clock clock_delta clock_on frame_number initial_frame final_frame "
    "initial_clock "
    "final_clock image_width image_height version true false on off yes no rgb rgbf rgbt rgbft "
    "srgb srgbf "
    "srgbt srgbft color colour red green blue filter transmit gray alpha abs acos acosh asc asin "
    "asinh atan "
    "atan2 atanh ceil chr concat cos cosh defined degrees dimension_size dimensions div exp "
    "file_exists "
    "floor int ln log max min mod pow radians rand seed select sin sinh sqr sqrt str strcmp strlen "
    "strlwr "
    "strupr substr tan tanh val vaxis_rotate vcross vdot vinv_transform vlength vnormalize vrotate "
    "vstr vtransform array";

/// Of POV-Ray's library, without ".inc": scenes name many of which they use nothing.
inline constexpr std::string_view pov_includes =
    "chars debug finish functions glass glass_old golds logo meshmaker metals rad_def rand screen "
    "shapes2 shapes3 shapes_old shapesq skies stage1 stars stdcam stdinc stoneold stones stones1 "
    "stones2 sunpos textures woodmaps woods";

inline constexpr std::string_view directives =
    "version include declare local undef macro end if ifdef ifndef else elseif while for switch "
    "case range "
    "break default debug warning error";

struct Advice {
    std::string_view words, advice;
};

inline constexpr Advice skipped[] = {
    {"photons caustics collect target pass_through",
     "light in stones is always traced in full here"},
    {"radiosity", "light between matt things is always traced"},
    {"subsurface translucency", "matt things let no light through"},
    {"phong phong_size specular roughness metallic irid irid_wavelength crand brilliance "
     "conserve_energy "
     "reflection reflection_exponent fresnel use_alpha diffuse_exponent",
     "opaque things are matt; stones reflect by the laws of Fresnel, always"},
    {"normal bump_map bump_size no_bump_scale normal_map slope_map interior_texture",
     "surfaces are smooth"},
    {"media fog rainbow media_attenuation media_interaction", "the air is clear"},
    {"hollow sturm bounded_by inside_vector split_union max_intersections adc_bailout "
     "noise_generator "
     "number_of_waves charset hf_gray_16 max_gradient accuracy quick_color "
     "quick_colour "
     "precision cutaway_textures",
     "it changes nothing here"},
    {"no_shadow no_image no_reflection double_illuminate", "everything is seen and casts shadows"},
    {"looks_like", "lamps are not seen: put the thing beside the lamp, which then lights up"},
    {"global_lights", "lamps shine on everything"},
    {"adaptive jitter area_illumination samples", "area lights are sampled evenly"},
    {"projected_through", "the lamp shines past it"},
    {"extinction", "stones take light by 'absorption' in 'crystal', or by 'fade_distance'"},
    {"dispersion_samples", "every wavelength is traced"},
    {"refraction", "a thing with an ior refracts"},
    {"normal_indices", "triangles are seen flat"},
    {"uv_mapping uv_vectors uv_indices", "surfaces have no coordinates of their own here"},
};

inline constexpr Advice refused[] = {
    {"difference", "use 'intersection' of planes, or 'cut', and say which facets are left"},
    {"isosurface parametric", "functions are not shapes here: use a 'mesh', or 'hull' for stones"},
    {"blob sphere_sweep superellipsoid torus lathe sor julia_fractal quadric cubic quartic poly "
     "ovus",
     "use a 'mesh' of triangles, 'sphere', 'cylinder' or 'cone'"},
    {"bicubic_patch height_field prism polygon text text_space",
     "use a 'mesh', or 'hull' for stones"},
    {"light_group", "lamps shine on everything: use 'union'"},
    {"texture_list", "give the mesh one texture, or make a mesh for each"},
    {"clipped_by", "use 'intersection' for stones"},
    {"image_pattern material_map pigment_map texture_map pigment_pattern "
     "bump_map",
     "use a colour, 'checker', 'grid', 'gradient' or 'image_map'"},
    {"agate average boxed bozo brick bumps cells crackle cylindrical density_file dents facets "
     "granite "
     "hexagon leopard mandel julia marble onion planar quilted radial ripples spiral1 "
     "spiral2 "
     "spotted tiling waves wood wrinkles slope object_pattern square triangular pavement",
     "use a plain colour, 'checker', 'grid' or 'gradient'"},
    {"turbulence warp frequency phase ramp_wave triangle_wave sine_wave scallop_wave cubic_wave "
     "poly_wave",
     "patterns cannot be bent: use a plain colour, 'checker', 'grid' or 'gradient'"},
    {"ultra_wide_angle omnimax panoramic mesh_camera",
     "use 'perspective', 'orthographic' or 'fisheye'"},
    {"spherical", "a camera may be 'fisheye' or 'perspective', a pattern 'gradient'"},
    {"b_spline bezier_spline conic_sweep linear_sweep", "use a 'mesh'"},
    {"fopen fclose read write render statistics", "a scene reads no data and writes no files"},
    {"trace inside min_extent max_extent vturbulence eval_pigment transform_space",
     "shapes cannot be asked questions here"},
};

/// Reserved by POV-Ray; nobody may declare them.
inline constexpr std::string_view others =
    "spline linear_spline quadratic_spline natural_spline "
    "aa_level aa_threshold agate_turb all all_intersections altitude always_sample anisotropy "
    "append "
    "arc_angle ascii assumed autostop black_hole blur brick_size brightness "
    "component composite contained_by control0 control1 coords count cubic_spline "
    "density "
    "density_map df3 dist_exp eccentricity error_bound evaluate expand_thresholds exponent "
    "exterior "
    "fade_distance fade_power falloff_angle flatness flip fog_alt fog_offset fog_type "
    "form "
    "gather gif gray_threshold hierarchy hypercomplex iff include inside internal "
    "intervals "
    "jpeg lambda load_file low_error_factor magnet major_radius max_extent "
    "max_iteration max_sample max_trace method metric minimum_reuse mortar nearest_count "
    ""
    "octaves offset omega orientation pattern pgm planar pot ppm "
    "precompute "
    "pretrace_end pretrace_start prod pwr quaternion range ratio reciprocal recursion_limit repeat "
    "save_file scattering size slice smooth solid spacing strength sum sys tga thickness threshold "
    "tiff "
    "tile2 tiles tolerance toroidal ttf turb_depth type u_steps use_color use_colour use_index "
    "utf8 "
    "v_steps water_level width";

}  // namespace icespar::word_lists
