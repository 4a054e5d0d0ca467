// A finished picture in memory and on disk. Files appear whole or not at all.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace icespar {

/// Planes of floats, row by row from the top. `rgb` is always there; `stokes` adds S1..S3 of each
/// colour; with bands, `s0` (and S1..S3) of each band. Values are radiances, see
/// docs/conventions.md.
struct Image {
    int width = 0, height = 0;
    /// Linear sRGB (S0): index (y * width + x) * 3 + channel.
    std::vector<float> rgb;
    /// Without bands and with stokes: index ((y * width + x) * 3 + channel) * 3 + (s - 1), s
    /// = 1..3.
    std::vector<float> rgb_stokes;
    /// Centres of the bands, nm, rising, equally spaced; empty when no bands were asked.
    std::vector<double> wavelengths_nm;
    /// Index ((y * width + x) * bands + band) * components + s; components 1 or 4.
    std::vector<float> spectral;
    int spectral_components = 0;
    /// Of the luminance, index y * width + x; empty when it is not known. In no file.
    std::vector<float> standard_error;
    /// What is written beside the pixels: scene, seed, samples, error estimate, dropped energy,
    /// version.
    std::map<std::string, std::string> metadata;
};

/// OpenEXR, float: R, G, B; with bands `S0.560,000000nm` ... (and S1..S3) after Fichet, Pacanowski
/// and Wilkie 2021; without bands and with stokes `S0.R` ... `S3.B` as Mitsuba 3 names them.
/// Metadata become string attributes named `icespar:KEY`. Throws Error.
void write_exr(const Image& image, const std::string& path);

/// 8-bit sRGB, clipped at 0 and 1; what is not a number is black. Throws Error.
void write_png(const Image& image, const std::string& path);
/// The same in memory.
[[nodiscard]] std::vector<unsigned char> png_bytes(const Image& image);

/// Runs `write` with a temporary name in the same folder, then renames to `path`; when `write`
/// throws, the temporary file is removed and `path` is untouched. A device or pipe is written to
/// directly. Throws Error when the folder is missing or `path` may not be written.
void write_whole(const std::string& path, const std::function<void(const std::string&)>& write);
/// The same for bytes that are there already.
void write_whole(const std::string& path, std::string_view bytes);

}  // namespace icespar
