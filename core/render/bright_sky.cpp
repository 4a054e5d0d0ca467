// Luminance of lamps and of a table over the sphere, summed up to draw from.
#include "render/bright_sky.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/surface.hpp"
#include "spectrum/spectrum.hpp"

namespace icespar {
namespace {

constexpr double turn = 2 * std::numbers::pi;
/// Of the table, at least and at most.
constexpr int fewest_rows = 128, most_rows = 512;

double luminance(const Spectrum& radiance) { return xyz_from_rgb(rgb_of(radiance))[1]; }

/// Within the cap about `axis` whose rim has this cosine, evenly.
Vec3 in_cap(const Vec3& axis, double solid_angle, double u, double v) {
    const double height = u * solid_angle / turn;  // 1 - cosine, without cancellation
    const double r = std::sqrt(height * (2 - height)), phi = turn * v;
    const Vec3 a = any_perpendicular(axis), b = cross(axis, a);
    return normalised(r * std::cos(phi) * a + r * std::sin(phi) * b + (1 - height) * axis);
}

}  // namespace

BrightSky::BrightSky(const Environment& sky) {
    double sum = 0;
    for (const Disc& disc : sky.discs) {
        const double solid_angle = turn * (1 - disc.cos_radius);
        const double power = solid_angle * luminance(sky.illuminant * disc.radiance);
        if (!(power > 0)) continue;
        discs_.push_back(disc);
        solid_angles_.push_back(solid_angle);
        reached_.push_back(sum += power);
    }
    if (sky.pattern || !sky.formulas.empty()) tabulate(sky);
}

double BrightSky::height_above(int row) const { return std::cos(0.5 * turn * row / rows_); }

double BrightSky::cell_solid_angle(int row) const {
    return (height_above(row) - height_above(row + 1)) * turn / (2 * rows_);
}

Vec3 BrightSky::in_cell(const Cell& cell, double u, double v) const {
    const double above = height_above(cell.row),
                 y = above + u * (height_above(cell.row + 1) - above),
                 r = std::sqrt(std::max(0.0, 1 - y * y)),
                 phi = turn * (cell.column + v) / (2 * rows_);
    return {r * std::cos(phi), y, r * std::sin(phi)};
}

void BrightSky::tabulate(const Environment& sky) {
    std::vector<double> colours;
    if (sky.pattern) {
        for (const Spectrum& c : sky.pattern->colours) {
            colours.push_back(luminance(sky.illuminant * c));
        }
    }
    const double white = luminance(sky.illuminant);
    const auto light = [&](const Vec3& d) {
        if (!sky.formulas.empty()) return white * formula_light(sky, d).s0;
        const Mix mix = mix_at(*sky.pattern, d, d);
        double value = 0;
        for (std::size_t i = 0; i < static_cast<std::size_t>(mix.count); ++i) {
            value += mix.share[i] * colours[mix.colour[i]];
        }
        return value;
    };
    double sum = reached_.empty() ? 0 : reached_.back();
    std::vector<double> reached = reached_;
    const int pixels = sky.pattern && sky.pattern->picture ? sky.pattern->picture->height : 0;
    rows_ = std::clamp(pixels / 2, fewest_rows, most_rows);
    // Points a side of a cell: no pixel of a panorama falls between them.
    const int side = std::clamp(1 + pixels / rows_, 2, 32);
    for (int row = 0; row < rows_; ++row) {
        for (int column = 0; column < 2 * rows_; ++column) {
            double value = 0;
            for (int i = 0; i < side * side; ++i) {
                const double u = (i / side + 0.5) / side, v = (i % side + 0.5) / side;
                value += std::max(0.0, light(in_cell({row, column}, u, v)));
            }
            reached.push_back(sum += cell_solid_angle(row) * value / (side * side));
        }
    }
    if (!(sum > 0)) {
        rows_ = 0;
        return;
    }
    reached_ = std::move(reached);
}

BrightSky::Cell BrightSky::cell_at(const Vec3& direction) const {
    const double round = std::atan2(direction.z, direction.x) / turn;
    const auto place = [](double x, int count) {
        return std::clamp(static_cast<int>(x * count), 0, count - 1);
    };
    return {place(2 / turn * std::acos(std::clamp(direction.y, -1.0, 1.0)), rows_),
            place(round < 0 ? round + 1 : round, 2 * rows_)};
}

Vec3 BrightSky::direction(double u, double v) const {
    const double total = reached_.back();
    const double wanted = std::min(u * total, std::nextafter(total, 0.0));
    const auto found = std::upper_bound(reached_.begin(), reached_.end(), wanted);
    const auto i =
        std::min(static_cast<std::size_t>(found - reached_.begin()), reached_.size() - 1);
    const double before = i > 0 ? reached_[i - 1] : 0;
    const double within = std::clamp((wanted - before) / (reached_[i] - before), 0.0, 1.0);
    if (i < discs_.size()) return in_cap(discs_[i].direction, solid_angles_[i], within, v);
    const auto cell = static_cast<int>(i - discs_.size());
    return in_cell({cell / (2 * rows_), cell % (2 * rows_)}, within, v);
}

double BrightSky::density(const Vec3& direction) const {
    double power = 0;
    for (std::size_t i = 0; i < discs_.size(); ++i) {
        if (dot(direction, discs_[i].direction) < discs_[i].cos_radius) continue;
        power += (reached_[i] - (i > 0 ? reached_[i - 1] : 0)) / solid_angles_[i];
    }
    if (rows_ > 0) {
        const Cell cell = cell_at(direction);
        const std::size_t i =
            discs_.size() + static_cast<std::size_t>(cell.row * 2 * rows_ + cell.column);
        power += (reached_[i] - (i > 0 ? reached_[i - 1] : 0)) / cell_solid_angle(cell.row);
    }
    return power / reached_.back();
}

}  // namespace icespar
