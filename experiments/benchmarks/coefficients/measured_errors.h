// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "endmill/core/error.h"
#include "endmill/process/cutting_coefficients.h"
#include "support/cpu_time.h"

namespace endmill {

/// Largest difference of a coefficient.
inline double largest_error(const CuttingCoefficients& a, const CuttingCoefficients& b)
{
    return std::max({std::abs(a.I1 - b.I1), std::abs(a.I2 - b.I2), std::abs(a.I3 - b.I3),
                     std::abs(a.I4 - b.I4), std::abs(a.I5 - b.I5), std::abs(a.I6 - b.I6),
                     std::abs(a.I7 - b.I7), std::abs(a.I8 - b.I8)});
}

/// Errors of `coefficients(engagement)` against values computed to 1e-12, in ascending
/// order.
template <typename Coefficients>
std::vector<double> sorted_errors(const std::vector<BallEngagement>& engagements,
                                  const Coefficients& coefficients)
{
    std::vector<double> errors;
    for (const BallEngagement& engagement : engagements)
        errors.push_back(
            largest_error(coefficients(engagement),
                          cutting_coefficients(engagement, ChipModel::Paper, 1e-12)));
    std::sort(errors.begin(), errors.end());
    return errors;
}

/// Shortest time of a call of `work(engagement)` on this thread, in us.
template <typename Work>
double us_a_point(const std::vector<BallEngagement>& engagements, const Work& work)
{
    constexpr double budget_s = 1;
    double kept = 0;
    const double time = shortest_cpu_s(budget_s, [&] {
        for (const BallEngagement& engagement : engagements)
            kept += work(engagement);
    });
    require(std::isfinite(kept), "us_a_point: a number is not finite");
    return 1e6 * time / static_cast<double>(engagements.size());
}

}  // namespace endmill
