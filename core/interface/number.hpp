// The number types of the general solver: real or complex, of any real type.
#pragma once

#include <cmath>
#include <complex>
#include <limits>
#include <type_traits>

#include "math/symmetric.hpp"

namespace icespar {

template <class T>
struct RealOf {
    using type = T;
};
template <class R>
struct RealOf<std::complex<R>> {
    using type = R;
};
template <class T>
using Real = typename RealOf<T>::type;

template <class T>
inline constexpr bool is_complex = !std::is_same_v<T, Real<T>>;

/// Roundings of a real type.
template <class R>
inline constexpr R rounding = std::numeric_limits<R>::epsilon();

template <class T>
Real<T> size2(const T& x) {
    if constexpr (is_complex<T>) {
        return std::norm(x);
    } else {
        return x * x;
    }
}

/// A norm that costs little.
template <class T>
Real<T> size1(const T& x) {
    if constexpr (is_complex<T>) {
        return std::abs(x.real()) + std::abs(x.imag());
    } else {
        return std::abs(x);
    }
}

template <class T>
T conjugate(const T& x) {
    if constexpr (is_complex<T>) {
        return std::conj(x);
    } else {
        return x;
    }
}

/// A complex number as it is, or its real part, as T can hold it.
template <class T>
T cast(const std::complex<Real<T>>& z) {
    if constexpr (is_complex<T>) {
        return z;
    } else {
        return z.real();
    }
}

template <class T>
SymmetricTensor<T> cast(const SymmetricTensor<std::complex<Real<T>>>& t) {
    if constexpr (is_complex<T>) {
        return t;
    } else {
        return real(t);
    }
}

}  // namespace icespar
