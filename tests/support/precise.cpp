// Eigenvalues, null spaces and linear systems of 4 x 4 complex matrices to sixty digits.
#include "support/precise.hpp"

#include <stdexcept>
#include <utility>

namespace reference {

Cplx square_root(const Cplx& z) {
    const Real r = magnitude(z);
    if (r == 0) return Cplx(0);
    const Real larger = sqrt((r + abs(re(z))) / 2), smaller = abs(im(z)) / (2 * larger);
    const Real sign = im(z) < 0 ? -1 : 1;
    return re(z) >= 0 ? Cplx(larger, sign * smaller) : Cplx(smaller, sign * larger);
}

namespace {

Real largest_element(const Matrix4& a) {
    Real largest = 0;
    for (const auto& row : a)
        for (const Cplx& z : row) largest = std::max(largest, magnitude(z));
    return largest;
}

/// The unitary [c s; -conj(s) c], c real, that turns (f, g) into (r, 0).
struct Givens {
    Real c = 1;
    Cplx s = 0;

    Givens(const Cplx& f, const Cplx& g) {
        const Real length = sqrt(norm2(f) + norm2(g)), size_f = magnitude(f);
        if (length == 0) return;
        c = size_f / length;
        s = (size_f == 0 ? Cplx(1) : f / size_f) * conjugate(g) / length;
    }
    void on_rows(Matrix4& a, int i, int j) const {
        for (int k = 0; k < 4; ++k) {
            const Cplx x = a[i][k], y = a[j][k];
            a[i][k] = c * x + s * y;
            a[j][k] = c * y - conjugate(s) * x;
        }
    }
    void on_columns(Matrix4& a, int i, int j) const {
        for (int k = 0; k < 4; ++k) {
            const Cplx x = a[k][i], y = a[k][j];
            a[k][i] = c * x + conjugate(s) * y;
            a[k][j] = c * y - s * x;
        }
    }
};

/// The eigenvalue of the 2 x 2 block ending at `last` that is nearer to its last element.
Cplx wilkinson_shift(const Matrix4& a, int last) {
    const Cplx p = a[last - 1][last - 1], q = a[last][last];
    const Cplx half = (p - q) / 2, product = a[last - 1][last] * a[last][last - 1];
    const Cplx root = square_root(half * half + product);
    const Cplx plus = half + root, minus = half - root;
    return q + (norm2(plus) < norm2(minus) ? plus : minus);
}

}  // namespace

std::array<Cplx, 4> eigenvalues(Matrix4 a) {
    const Real tiny = largest_element(a) * std::numeric_limits<Real>::epsilon() * 16;
    for (int column = 0; column < 2; ++column)
        for (int row = 3; row > column + 1; --row) {
            const Givens g(a[row - 1][column], a[row][column]);
            g.on_rows(a, row - 1, row);
            g.on_columns(a, row - 1, row);
        }
    int steps = 0;
    for (int last = 3; last > 0;) {
        int first = last;
        while (first > 0 && magnitude(a[first][first - 1]) > tiny) --first;
        if (first == last) {
            --last, steps = 0;
            continue;
        }
        if (++steps > 400) throw std::runtime_error("reference: QR iteration does not converge");
        // A shift off the pattern now and then breaks the cycles of symmetric spectra.
        const Cplx shift = steps % 12 == 0 ? a[last][last] + Cplx(magnitude(a[last][last - 1]), 0)
                                           : wilkinson_shift(a, last);
        for (int i = first; i <= last; ++i) a[i][i] -= shift;
        std::vector<Givens> rotations;
        for (int i = first; i < last; ++i) {
            rotations.emplace_back(a[i][i], a[i + 1][i]);
            rotations.back().on_rows(a, i, i + 1);
        }
        for (int i = first; i < last; ++i) rotations[i - first].on_columns(a, i, i + 1);
        for (int i = first; i <= last; ++i) a[i][i] += shift;
    }
    return {a[0][0], a[1][1], a[2][2], a[3][3]};
}

namespace {

/// Upper triangular form of `a` by complete pivoting; column_order[i] is the unknown in column i.
std::array<int, 4> eliminate(Matrix4& a, Vector4& b) {
    std::array<int, 4> column_order{0, 1, 2, 3};
    for (int step = 0; step < 4; ++step) {
        int row = step, column = step;
        for (int i = step; i < 4; ++i)
            for (int j = step; j < 4; ++j)
                if (norm2(a[i][j]) > norm2(a[row][column])) row = i, column = j;
        std::swap(a[step], a[row]);
        std::swap(b[step], b[row]);
        for (auto& r : a) std::swap(r[step], r[column]);
        std::swap(column_order[step], column_order[column]);
        if (norm2(a[step][step]) == 0) break;
        for (int i = step + 1; i < 4; ++i) {
            const Cplx factor = a[i][step] / a[step][step];
            for (int j = step; j < 4; ++j) a[i][j] -= factor * a[step][j];
            b[i] -= factor * b[step];
        }
    }
    return column_order;
}

}  // namespace

std::vector<Vector4> null_space(Matrix4 a) {
    const Real threshold = largest_element(a) * Real("1e-35");
    Vector4 unused{};
    const auto order = eliminate(a, unused);
    int rank = 0;
    while (rank < 3 && magnitude(a[rank][rank]) > threshold) ++rank;
    std::vector<Vector4> basis;
    for (int free = rank; free < 4; ++free) {
        Vector4 x{};
        x[order[free]] = 1;
        for (int i = rank - 1; i >= 0; --i) {
            Cplx sum = a[i][free];
            for (int j = i + 1; j < rank; ++j) sum += a[i][j] * x[order[j]];
            x[order[i]] = -sum / a[i][i];
        }
        basis.push_back(x);
    }
    return basis;
}

Vector4 solve_linear(Matrix4 a, Vector4 b) {
    const auto order = eliminate(a, b);
    Vector4 x{};
    for (int i = 3; i >= 0; --i) {
        Cplx sum = b[i];
        for (int j = i + 1; j < 4; ++j) sum -= a[i][j] * x[order[j]];
        x[order[i]] = sum / a[i][i];
    }
    return x;
}

}  // namespace reference
