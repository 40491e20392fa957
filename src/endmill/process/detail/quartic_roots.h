// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace endmill {

/// Coefficients of c[0] + c[1] u + ... + c[4] u^4.
using Quartic = std::array<double, 5>;

/// Roots of a quartic and of its derivative.
struct RootsAndExtrema {
    std::array<double, 7> at;  ///< ascending; the first `count` entries are valid
    int count = 0;             ///< number of entries
};

/// The real roots of a quartic and of its derivative in [low, high]. Between two
/// neighbouring ones the quartic is monotonic and has one sign.
///
/// The roots are found from the second derivative upwards: between neighbouring roots of
/// its derivative a polynomial is monotonic and has at most one root, which is bracketed.
/// Any coefficient may vanish, also the leading one. A pair of roots closer than about
/// 1e-8 may be missed, but not the root of the derivative between them.
/// \param quartic the coefficients; finite.
/// \param low lower end of the interval, of the order of 1.
/// \param high upper end of the interval, above `low`.
/// Simple roots are accurate to 1e-12 if the coefficients are of the order of 1.
RootsAndExtrema roots_and_extrema(const Quartic& quartic, double low, double high);

}  // namespace endmill
