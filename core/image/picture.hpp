// A picture that a scene wears: read from OpenEXR or PNG, and looked up between its pixels.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace icespar {

/// Linear sRGB, row by row from the top, each row from the left.
struct Picture {
    int width = 0, height = 0;
    std::vector<float> rgb;

    [[nodiscard]] std::array<double, 3> pixel(int x, int y) const {
        const float* p = &rgb[(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                               static_cast<std::size_t>(x)) *
                              3];
        return {p[0], p[1], p[2]};
    }
    /// Linear between the centres of pixels; (0, 0) is the upper left corner, (1, 1) the lower
    /// right. Beyond the edge x goes round, and y too when `y_goes_round`, or else keeps the edge.
    [[nodiscard]] std::array<double, 3> between(double x, double y, bool y_goes_round) const;
};

/// Reads .exr (R, G, B or Y, of the first part) or .png (by its gamma); alpha is left out. Throws
/// Error when it cannot be read, holds more than 2^26 pixels or a value that is negative or not
/// finite.
[[nodiscard]] Picture read_picture(const std::string& path);

}  // namespace icespar
