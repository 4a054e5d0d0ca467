// High-precision real and complex numbers, and 4 x 4 linear algebra on them for the Maxwell
// reference.
#pragma once

#include <array>
#include <boost/multiprecision/complex_adaptor.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <vector>

namespace reference {

namespace mp = boost::multiprecision;
using Digits = mp::cpp_bin_float<75>;  // sixty, and what degenerate cases lose; still four limbs
using Real = mp::number<Digits, mp::et_off>;
using Cplx = mp::number<mp::complex_adaptor<Digits>, mp::et_off>;

template <std::size_t N>
using Row = std::array<Cplx, N>;
using Matrix4 = std::array<Row<4>, 4>;
using Vector4 = Row<4>;

inline Real re(const Cplx& z) { return z.real(); }
inline Real im(const Cplx& z) { return z.imag(); }
inline Cplx conjugate(const Cplx& z) { return Cplx(re(z), -im(z)); }
inline Real norm2(const Cplx& z) { return re(z) * re(z) + im(z) * im(z); }
inline Real magnitude(const Cplx& z) { return sqrt(norm2(z)); }

/// Principal square root; accurate beside both axes.
Cplx square_root(const Cplx& z);

/// All eigenvalues, by reduction to Hessenberg form and shifted QR steps. Semi-simple multiple
/// eigenvalues (isotropic media) keep full accuracy; defective ones (exactly critical) keep half.
std::array<Cplx, 4> eigenvalues(Matrix4 a);

/// A basis of the x with a x = 0, never empty: at least the direction of the smallest pivot.
/// Pivots below 1e-35 of the largest element count as zero.
std::vector<Vector4> null_space(Matrix4 a);

/// The x with a x = b, by elimination with complete pivoting.
Vector4 solve_linear(Matrix4 a, Vector4 b);

}  // namespace reference
