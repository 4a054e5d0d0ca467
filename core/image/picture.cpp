// Reading pictures: OpenEXR and libpng do the work, bounds and faults are ours.
#include "image/picture.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <png.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <tuple>

#include "math/error.hpp"

namespace icespar {
namespace {

constexpr long long most_pixels = 1LL << 26;

void check_size(long long width, long long height, const std::string& path) {
    if (width < 1 || height < 1 || width > most_pixels || height > most_pixels / width) {
        throw Error("'" + path + "' has " + std::to_string(width) + " x " + std::to_string(height) +
                    " pixels; 1 to 2^26 of them can be read");
    }
}

Picture read_exr(const std::string& path) {
    try {
        Imf::InputFile file(path.c_str(), 1);
        const Imath::Box2i window = file.header().dataWindow();
        const long long width = static_cast<long long>(window.max.x) - window.min.x + 1;
        const long long height = static_cast<long long>(window.max.y) - window.min.y + 1;
        check_size(width, height, path);
        Picture out{static_cast<int>(width), static_cast<int>(height), {}};
        out.rgb.resize(static_cast<std::size_t>(width * height * 3));
        const Imf::ChannelList& channels = file.header().channels();
        const bool grey = channels.findChannel("R") == nullptr;
        if (grey && channels.findChannel("Y") == nullptr) {
            throw Error("'" + path + "' has neither the channels R, G, B nor Y");
        }
        constexpr std::size_t step = 3 * sizeof(float);
        Imf::FrameBuffer places;
        for (std::size_t c = 0; c < (grey ? 1 : 3); ++c) {
            char* first = reinterpret_cast<char*>(out.rgb.data() + c) -
                          (window.min.x + window.min.y * width) * static_cast<long long>(step);
            places.insert(
                grey ? "Y" : std::string(1, "RGB"[c]),
                Imf::Slice(Imf::FLOAT, first, step, step * static_cast<std::size_t>(width)));
        }
        file.setFrameBuffer(places);
        file.readPixels(window.min.y, window.max.y);
        for (std::size_t i = 0; grey && i < out.rgb.size(); i += 3) {
            out.rgb[i + 1] = out.rgb[i + 2] = out.rgb[i];
        }
        return out;
    } catch (const Error&) {
        throw;
    } catch (const std::exception& error) {
        throw Error("'" + path + "' cannot be read as OpenEXR: " + error.what());
    }
}

Picture read_png(const std::string& path) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    const auto check = [&](int done) {
        if (done != 0) return;
        const std::string why = png.message;
        png_image_free(&png);
        throw Error("'" + path + "' cannot be read as PNG: " + why);
    };
    check(png_image_begin_read_from_file(&png, path.c_str()));
    try {
        check_size(png.width, png.height, path);
    } catch (...) {
        png_image_free(&png);
        throw;
    }
    png.format = PNG_FORMAT_LINEAR_RGB;
    Picture out{static_cast<int>(png.width), static_cast<int>(png.height), {}};
    std::vector<png_uint_16> pixels(static_cast<std::size_t>(png.width) * png.height * 3);
    const png_color black{};
    check(png_image_finish_read(&png, &black, pixels.data(), 0, nullptr));
    out.rgb.resize(pixels.size());
    std::transform(pixels.begin(), pixels.end(), out.rgb.begin(),
                   [](png_uint_16 v) { return static_cast<float>(v) / 65535.0F; });
    return out;
}

}  // namespace

Picture read_picture(const std::string& path) {
    std::string ending = path.substr(std::min(path.rfind('.'), path.size()));
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (ending != ".exr" && ending != ".png") {
        throw Error("'" + path + "' is neither .exr nor .png: convert it to one of them");
    }
    Picture out = ending == ".exr" ? read_exr(path) : read_png(path);
    for (const float v : out.rgb) {
        if (!(v >= 0 && std::isfinite(v))) {
            throw Error("'" + path +
                        "' holds a value that is negative or not finite: light and "
                        "reflectance are neither");
        }
    }
    return out;
}

std::array<double, 3> Picture::between(double x, double y, bool y_goes_round) const {
    const auto place = [](double t, int size, bool round) {
        const double at = t * size - 0.5, below = std::floor(at);
        const auto cell = [&](double i) {
            if (round) return static_cast<int>(i - size * std::floor(i / size)) % size;
            return static_cast<int>(std::clamp(i, 0.0, size - 1.0));
        };
        return std::tuple{cell(below), cell(below + 1), at - below};
    };
    const auto [x0, x1, u] = place(x, width, true);
    const auto [y0, y1, v] = place(y, height, y_goes_round);
    const auto a = pixel(x0, y0), b = pixel(x1, y0), c = pixel(x0, y1), d = pixel(x1, y1);
    std::array<double, 3> out{};
    for (std::size_t i = 0; i < 3; ++i) {
        out[i] = (1 - v) * ((1 - u) * a[i] + u * b[i]) + v * ((1 - u) * c[i] + u * d[i]);
    }
    return out;
}

}  // namespace icespar
