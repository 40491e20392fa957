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

/// The next guess of a root.
struct RootStep {
    double next;     ///< within the bracket
    bool is_newton;  ///< false if it is the middle of the bracket
};

/// One step from `at` towards the root in [low, high]: Newton's, or the middle of the
/// bracket where Newton's would leave it.
inline RootStep root_step(double low, double high, double at, const ValueAndSlope& here)
{
    const double newton = at - here.value / here.slope;
    if (low <= newton && newton <= high)  // false for NaN
        return {newton, true};
    return {(low + high) / 2, false};
}

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
        const double next = root_step(low, high, at, here).next;
        const double change = std::abs(next - at);
        at = next;
        if (change < least_step)
            break;
    }
    return at;
}

}  // namespace endmill
