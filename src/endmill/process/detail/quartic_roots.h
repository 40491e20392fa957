// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace endmill {

/// c[0] + c[1] u + ... + c[4] u^4.
using Quartic = std::array<double, 5>;

/// Places on a line, rising.
struct RootsAndExtrema {
    std::array<double, 7> at;  ///< the first `count` of them hold
    int count = 0;
};

/// Where the quartic or its derivative vanishes, low <= u <= high: between two found that
/// follow each other it is monotonic and has one sign. The roots of each derivative part
/// the line into stretches on which the next has one root at most, which is bracketed; so
/// no coefficient, not even the leading one, may not vanish. Two roots closer than about
/// 1e-8 may be missed; the derivative's root between them is not.
/// \pre low < high, not far from 1 in size; coefficients are finite.
/// Simple roots are good to 1e-12 where the coefficients are about 1.
RootsAndExtrema roots_and_extrema(const Quartic& quartic, double low, double high);

}  // namespace endmill
