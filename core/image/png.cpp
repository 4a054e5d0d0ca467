// PNG files: 8 bits a channel through the sRGB curve.
#include <png.h>

#include <algorithm>
#include <cmath>

#include "image/checked_file.hpp"
#include "image/image.hpp"
#include "image/layout.hpp"
#include "math/error.hpp"

namespace icespar {
namespace {

/// The transfer function of IEC 61966-2-1, to the nearest of 256 steps. What is not a number is
/// black.
unsigned char srgb_byte(float linear) {
    if (!(linear > 0)) return 0;
    const double v = std::min<double>(linear, 1);
    const double encoded = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
    return static_cast<unsigned char>(std::lround(255 * encoded));
}

}  // namespace

std::vector<unsigned char> png_bytes(const Image& image) {
    check_layout(image);
    std::vector<unsigned char> pixels(image.rgb.size());
    std::transform(image.rgb.begin(), image.rgb.end(), pixels.begin(), srgb_byte);

    // libpng's simplified interface: marks 8-bit RGB as sRGB, and reports errors without longjmp.
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = static_cast<png_uint_32>(image.width);
    png.height = static_cast<png_uint_32>(image.height);
    png.format = PNG_FORMAT_RGB;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
    std::vector<unsigned char> bytes(size);
    if (!png_image_write_to_memory(&png, bytes.data(), &size, 0, pixels.data(), 0, nullptr))
        throw Error("cannot make a PNG of " + std::to_string(image.width) + " x " +
                    std::to_string(image.height) + ": " + png.message + "; write OpenEXR instead");
    bytes.resize(size);
    return bytes;
}

void write_png(const Image& image, const std::string& path) {
    const std::vector<unsigned char> bytes = png_bytes(image);
    write_whole(path, [&](const std::string& partial) {
        CheckedFile file(partial, path);
        file.write(bytes.data(), bytes.size());
        file.close();
    });
}

}  // namespace icespar
