// Mueller and Jones matrices and the passage between them.
#include "polarisation/mueller.hpp"

#include <algorithm>
#include <numbers>

namespace icespar {
namespace {

using Complex = std::complex<double>;
using Matrix2 = std::array<std::array<Complex, 2>, 2>;

/// S_i = tr(sigma_i E E^+).
const std::array<Matrix2, 4>& sigma() {
    static const std::array<Matrix2, 4> matrices{{{{{1.0, 0.0}, {0.0, 1.0}}},
                                                  {{{1.0, 0.0}, {0.0, -1.0}}},
                                                  {{{0.0, 1.0}, {1.0, 0.0}}},
                                                  {{{0.0, Complex(0, 1)}, {Complex(0, -1), 0.0}}}}};
    return matrices;
}

Matrix2 times(const Matrix2& a, const Matrix2& b) {
    Matrix2 out{};
    for (std::size_t i = 0; i < 2; ++i) {
        for (std::size_t j = 0; j < 2; ++j) out[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j];
    }
    return out;
}

Matrix2 adjoint(const Matrix2& a) {
    return {{{std::conj(a[0][0]), std::conj(a[1][0])}, {std::conj(a[0][1]), std::conj(a[1][1])}}};
}

}  // namespace

Mueller mueller_from_jones(const Jones& j) {
    Mueller out;
    const Matrix2 back = adjoint(j.m);
    for (std::size_t b = 0; b < 4; ++b) {
        const Matrix2 sent = times(times(j.m, sigma()[b]), back);
        for (std::size_t a = 0; a < 4; ++a) {
            const Matrix2 t = times(sigma()[a], sent);
            out.m[a][b] = 0.5 * (t[0][0] + t[1][1]).real();
        }
    }
    return out;
}

Jones jones_from_mueller(const Mueller& m) {
    // Coherency matrix H = 1/4 sum M_ab (sigma_a x conj(sigma_b)), acting on vectors J_ij by row;
    // it is |J><J| / 2 for a Jones matrix.
    std::array<std::array<Complex, 4>, 4> H{};
    for (std::size_t a = 0; a < 4; ++a) {
        for (std::size_t b = 0; b < 4; ++b) {
            for (std::size_t r = 0; r < 4; ++r) {
                for (std::size_t c = 0; c < 4; ++c) {
                    H[r][c] += 0.5 * m.m[a][b] * sigma()[a][r / 2][c / 2] *
                               std::conj(sigma()[b][r % 2][c % 2]);
                }
            }
        }
    }
    // Squaring brings out the largest eigenvector.
    auto power = H;
    for (int step = 0; step < 40; ++step) {
        std::array<std::array<Complex, 4>, 4> next{};
        double size = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t k = 0; k < 4; ++k) {
                for (std::size_t j = 0; j < 4; ++j) next[i][j] += power[i][k] * power[k][j];
            }
        }
        for (const auto& row : next) {
            for (const Complex& z : row) size = std::max(size, std::abs(z));
        }
        if (size == 0) return {};
        for (auto& row : next) {
            for (Complex& z : row) z /= size;
        }
        power = next;
    }
    std::size_t best = 0;
    for (std::size_t i = 1; i < 4; ++i) {
        if (power[i][i].real() > power[best][best].real()) best = i;
    }
    std::array<Complex, 4> v;
    double size = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        v[i] = power[i][best];
        size += std::norm(v[i]);
    }
    Complex value = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) value += std::conj(v[i]) * H[i][j] * v[j];
    }
    const double scale = std::sqrt(std::max(value.real() / size, 0.0) / size);
    const Complex turn = std::conj(v[best]) / std::abs(v[best]) * scale;
    return {{{{turn * v[0], turn * v[1]}, {turn * v[2], turn * v[3]}}}};
}

Mueller rotator(double angle) {
    const double c = std::cos(2 * angle), s = std::sin(2 * angle);
    return {{{{1, 0, 0, 0}, {0, c, -s, 0}, {0, s, c, 0}, {0, 0, 0, 1}}}};
}

Mueller linear_retarder(double retardance, double fast_axis) {
    const double c = std::cos(retardance), s = std::sin(retardance);
    const Mueller along_x{{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, c, s}, {0, 0, -s, c}}}};
    return turned(along_x, fast_axis);
}

Mueller circular_retarder(double retardance) { return rotator(-0.5 * retardance); }

Mueller linear_diattenuator(double along, double across, double axis) {
    const double mean = 0.5 * (along + across), half = 0.5 * (along - across),
                 rest = std::sqrt(along * across);
    const Mueller along_x{
        {{{mean, half, 0, 0}, {half, mean, 0, 0}, {0, 0, rest, 0}, {0, 0, 0, rest}}}};
    return turned(along_x, axis);
}

Mueller linear_polariser(double axis) { return linear_diattenuator(1, 0, axis); }

Mueller circular_polariser(bool right) {
    const double s = right ? 0.5 : -0.5;
    return {{{{0.5, 0, 0, s}, {0, 0, 0, 0}, {0, 0, 0, 0}, {s, 0, 0, 0.5}}}};
}

Mueller depolariser(double a1, double a2, double a3) {
    return {{{{1, 0, 0, 0}, {0, a1, 0, 0}, {0, 0, a2, 0}, {0, 0, 0, a3}}}};
}

Mueller mueller_of_wave(Complex analyser_x, Complex analyser_y, const Stokes& out) {
    // |x Ex + y Ey|^2 = 1/2 a . S with a the Stokes vector of the conjugate of (x, y).
    const Stokes a = stokes_from_field(std::conj(analyser_x), std::conj(analyser_y));
    const std::array<double, 4> accepted{a.s0, a.s1, a.s2, a.s3};
    const std::array<double, 4> sent{1, out.s1 / out.s0, out.s2 / out.s0, out.s3 / out.s0};
    Mueller m;
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) m.m[i][j] = 0.5 * sent[i] * accepted[j];
    }
    return m;
}

double depolarisation_index(const Mueller& m) {
    double sum = 0;
    for (const auto& row : m.m) {
        for (const double x : row) sum += x * x;
    }
    const double m00 = m.m[0][0];
    return m00 > 0 ? std::sqrt(std::max(sum - m00 * m00, 0.0) / 3) / m00 : 0;
}

double diattenuation(const Mueller& m) {
    const auto& row = m.m[0];
    return row[0] > 0 ? std::sqrt(row[1] * row[1] + row[2] * row[2] + row[3] * row[3]) / row[0] : 0;
}

double polarisance(const Mueller& m) {
    const double a = m.m[1][0], b = m.m[2][0], c = m.m[3][0];
    return m.m[0][0] > 0 ? std::sqrt(a * a + b * b + c * c) / m.m[0][0] : 0;
}

double retardance(double n_fast, double n_slow, double length_mm, double wavelength_nm) {
    return 2 * std::numbers::pi * (n_slow - n_fast) * length_mm / (wavelength_nm * 1e-6);
}

}  // namespace icespar
