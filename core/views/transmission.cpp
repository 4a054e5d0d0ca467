// Over a triangle the mean of a function of a linear number is twice its second divided difference
// of the corners' values (Hermite and Genocchi).
#include "views/transmission.hpp"

#include <algorithm>
#include <cmath>

namespace icespar {
namespace {

/// Over an interval.
double mean_exp(double a, double b) {
    return a == b ? std::exp(-a) : std::exp(-a) * -std::expm1(a - b) / (b - a);
}

double mean_exp(double a, double b, double c) {
    if (a > b) std::swap(a, b);
    if (b > c) std::swap(b, c);
    if (a > b) std::swap(a, b);
    constexpr double close = 0.05;
    if (c - a > close) return 2 * (mean_exp(a, b) - mean_exp(b, c)) / (c - a);
    // Moments about the middle: of order n, 2 n! / (n + 2)! times the complete symmetric
    // polynomial.
    const double m = (a + b + c) / 3, x = a - m, y = b - m, z = c - m;
    const double p2 = x * x + y * y + z * z, p3 = x * x * x + y * y * y + z * z * z;
    return std::exp(-m) * (1 + p2 / 24 - p3 / 180 + p2 * p2 / 1440 - p2 * p3 / 7560);
}

}  // namespace

double mean_transmission(PolygonView polygon, const Affine& depth) {
    double sum = 0, area = 0;
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        const Point2 a = polygon[i - 1] - polygon[0], b = polygon[i] - polygon[0];
        const double part = a.x * b.y - a.y * b.x;
        area += part;
        sum += part * mean_exp(depth(polygon[0]), depth(polygon[i - 1]), depth(polygon[i]));
    }
    // In a sliver rounding takes over: the mean is never beyond those of the corners.
    const auto [low, high] = range_of(polygon, depth);
    return std::fmin(std::exp(-low), std::fmax(std::exp(-high), sum / area));
}

}  // namespace icespar
