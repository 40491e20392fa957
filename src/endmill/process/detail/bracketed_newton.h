// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace endmill {

/// Where a function of one variable is looked for a root.
struct RootBracket {
    double low;   ///< one end
    double high;  ///< the other, above it
    bool
        rises;  ///< the function is above zero at `high`, and not at `low`; else the reverse
    double start;  ///< first place, in the bracket
};

/// A function at a place.
struct ValueAndSlope {
    double value;
    double slope;  ///< to the place; may be 0
};

/// A root in a bracket by Newton's steps, halved where one would leave it.
/// \param least_step a step that changes less, in the variable's unit, ends the search;
///        it ends after 60 steps in any case, more than halving would need for a bracket
///        of 2 and a step of 1e-15.
/// \param function gives the `ValueAndSlope` at a place.
template <typename Function>
double bracketed_newton(RootBracket bracket, double least_step, const Function& function)
{
    constexpr int most_steps = 60;
    auto [low, high, rises, at] = bracket;
    for (int k = 0; k < most_steps; ++k) {
        const ValueAndSlope here = function(at);
        (here.value > 0) == rises ? high = at : low = at;
        double next = at - here.value / here.slope;
        if (!(low <= next && next <= high))  // nor is NaN within
            next = (low + high) / 2;
        const double change = std::abs(next - at);
        at = next;
        if (change < least_step)
            break;
    }
    return at;
}

}  // namespace endmill
