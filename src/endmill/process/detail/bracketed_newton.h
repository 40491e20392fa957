// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace endmill {

/// An interval in which a function changes its sign, and a first guess of the root.
struct RootBracket {
    double low;   ///< lower end
    double high;  ///< upper end
    /// True if the function is positive at `high` and not at `low`, false for the
    /// reverse.
    bool rises;
    double start;  ///< first guess, within the bracket
};

/// Value and derivative of a function.
struct ValueAndSlope {
    double value;  ///< of the function
    double slope;  ///< of its derivative; may be 0
};

/// Root of a function in a bracket, by Newton's method. A step that would leave the
/// bracket is replaced by bisection.
/// \param bracket the bracket.
/// \param least_step a smaller change of the variable ends the iteration. It ends after
///        60 steps in any case, which exceeds what bisection needs for a bracket of width
///        2 and a step of 1e-15.
/// \param function returns the ValueAndSlope at a place.
template <typename Function>
double bracketed_newton(RootBracket bracket, double least_step, const Function& function)
{
    constexpr int most_steps = 60;
    auto [low, high, rises, at] = bracket;
    for (int k = 0; k < most_steps; ++k) {
        const ValueAndSlope here = function(at);
        (here.value > 0) == rises ? high = at : low = at;
        double next = at - here.value / here.slope;
        if (!(low <= next && next <= high))  // also true for NaN
            next = (low + high) / 2;
        const double change = std::abs(next - at);
        at = next;
        if (change < least_step)
            break;
    }
    return at;
}

}  // namespace endmill
