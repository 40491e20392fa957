// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace endmill {

/// The four cubic Bernstein polynomials C(3,i) t^i (1-t)^(3-i) at t, one in each row:
/// values in the first column, first derivatives in the second, second derivatives in the
/// third.
/// Source: [KimChoi, section 2].
template <int Columns>
Eigen::Matrix<double, 4, Columns> cubic_bernstein(double t)
{
    static_assert(2 <= Columns && Columns <= 3);
    const double s = 1 - t;
    Eigen::Matrix<double, 4, Columns> basis;
    basis.col(0) << s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t;
    basis.col(1) << -3 * s * s, 3 * s * (s - 2 * t), 3 * t * (2 * s - t), 3 * t * t;
    if constexpr (Columns > 2)
        basis.col(2) << 6 * s, 6 * (t - 2 * s), 6 * (s - 2 * t), 6 * t;
    return basis;
}

}  // namespace endmill
