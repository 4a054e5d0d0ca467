// Whether the planes of an image have the sizes it states.
#include "image/layout.hpp"

#include <cmath>

#include "math/error.hpp"

namespace icespar {

void check_layout(const Image& image) {
    if (image.width < 1 || image.height < 1)
        throw Error("a picture of " + std::to_string(image.width) + " x " +
                    std::to_string(image.height) +
                    " cannot be written; give it at least one pixel");
    const std::size_t pixels =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    const auto check = [&](const char* plane, std::size_t has, std::size_t wanted) {
        if (has != wanted)
            throw Error(std::string("the plane '") + plane + "' of a picture of " +
                        std::to_string(image.width) + " x " + std::to_string(image.height) +
                        " holds " + std::to_string(has) + " numbers; give it " +
                        std::to_string(wanted));
    };
    check("rgb", image.rgb.size(), 3 * pixels);
    if (!image.rgb_stokes.empty()) check("rgb_stokes", image.rgb_stokes.size(), 9 * pixels);

    const std::size_t bands = image.wavelengths_nm.size();
    if (bands > 0 && image.spectral_components != 1 && image.spectral_components != 4)
        throw Error("a picture has " + std::to_string(image.spectral_components) +
                    " components a band; give it 1 (intensity) or 4 (Stokes)");
    const std::size_t components =
        bands > 0 ? static_cast<std::size_t>(image.spectral_components) : 0;
    check("spectral", image.spectral.size(), pixels * bands * components);
    for (std::size_t i = 0; i < bands; ++i)
        if (!(image.wavelengths_nm[i] > (i > 0 ? image.wavelengths_nm[i - 1] : 0.0)) ||
            !std::isfinite(image.wavelengths_nm[i]))
            throw Error("a picture's wavelengths do not rise at band " + std::to_string(i + 1) +
                        "; sort them");
}

}  // namespace icespar
