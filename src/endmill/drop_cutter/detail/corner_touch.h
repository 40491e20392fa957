// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>

#include "endmill/core/detail/exact_arithmetic.h"
#include "endmill/core/tolerance.h"
#include "endmill/drop_cutter/detail/triangle_contact.h"

namespace endmill {

/// A number as a double. A Real is a double or a DoubleDouble.
inline double value_of(double number)
{
    return number;
}

/// A DoubleDouble rounded to a double.
inline double value_of(const DoubleDouble& number)
{
    return number.value();
}

/// The larger of `value` and 0.
template <typename Real>
Real positive(const Real& value)
{
    return value > Real{0} ? value : Real{0};
}

/// The radii of a cutter with all digits of Real; see Cutter.
template <typename Real>
struct CutterShape {
    Real R;  ///< cutter radius, mm
    Real r;  ///< corner radius, mm
    Real c;  ///< R - r, radius of the flat bottom, mm
};

/// A line that rises beside a cutter's axis.
template <typename Real>
struct RisingLine {
    Real slope;   ///< m >= 0
    Real away2;   ///< square of its distance from the axis, mm^2
    Real height;  ///< height of the line where it is nearest to the axis, mm
};

/// The contact of the rounded corner of a bull-nose cutter with a rising line. Let t be
/// the distance in plan along the line from its point nearest to the axis, d the distance
/// from the axis, and a = d - c. The height of the tip, line minus profile, is a concave
/// function of t. Its maximum is where a t / d = m sqrt(r^2 - a^2).
template <typename Real>
class CornerTouch {
public:
    /// \pre `shape` and `line` outlive this object.
    CornerTouch(const CutterShape<Real>& shape, const RisingLine<Real>& line)
        : shape_{shape},
          line_{line}
    {
    }

    /// The t of the highest tip between `lowest` and `high`.
    /// \param lowest smallest t below the cutter.
    /// \param high largest t below the cutter.
    /// \param least mm; lower tips are of no interest.
    /// \return nothing if a bound shows that the tip is below `least`.
    std::optional<Real> highest(const Real& lowest, const Real& high, double least) const
    {
        using std::sqrt;
        const Real& m = line_.slope;
        // Below the flat bottom the tip rises with the line, so that its far end counts;
        // on a level line the point nearest to the axis is taken.
        const Real flat =
            m > Real{0} ? sqrt(positive(shape_.c * shape_.c - line_.away2)) : Real{0};
        const Real low = lowest < flat ? (flat < high ? flat : high) : lowest;
        const Real tube = shape_.c + shape_.r * m / sqrt(Real{1} + m * m);
        const Real guess = sqrt(positive(tube * tube - line_.away2));
        const Real t = guess < low ? low : (guess > high ? high : guess);
        if (at(t).bound(low, high) < least)
            return std::nullopt;
        if (!(at(low).value < Real{0}))
            return low;
        if (!(at(high).value > Real{0}))
            return high;
        return root({low, t, high}, least);
    }

    /// Height of the cutter's surface above its tip at t, mm.
    Real profile(const Real& t) const
    {
        using std::sqrt;
        const Real a = positive(sqrt(line_.away2 + t * t) - shape_.c);
        return shape_.r - sqrt(positive((shape_.r - a) * (shape_.r + a)));
    }

private:
    struct Bracket {
        Real low;
        Real t;
        Real high;
    };

    // At one t: the function a t / d - m root whose zero is sought, its derivative, the
    // tip and its slope.
    struct Slopes {
        Real t;
        Real value;
        Real rise;
        Real tip;
        Real tip_slope;
        bool is_at_rim;

        // An upper bound of the tip over low … high: the tangent of a concave function.
        double bound(const Real& low, const Real& high) const
        {
            if (is_at_rim)
                return std::numeric_limits<double>::infinity();
            return std::max(value_of(tip + tip_slope * (low - t)),
                            value_of(tip + tip_slope * (high - t))) +
                   tip_accuracy;
        }
    };

    Slopes at(const Real& t) const
    {
        using std::sqrt;
        const Real& m = line_.slope;
        const Real d = sqrt(line_.away2 + t * t);
        const Real a = positive(d - shape_.c);
        const Real root = sqrt(positive((shape_.r - a) * (shape_.r + a)));
        const Real share = d > Real{0} ? t / d : Real{1};
        Slopes slopes{t, a * share - m * root, share * share, Real{0}, Real{0}, true};
        if (d > Real{0})
            slopes.rise = slopes.rise + a * line_.away2 / (d * d * d);
        if (!(root > Real{0}))
            return slopes;
        slopes.is_at_rim = false;
        slopes.rise = slopes.rise + m * a * share / root;
        slopes.tip_slope = m - a * share / root;
        slopes.tip = line_.height + m * t - (shape_.r - root);
        return slopes;
    }

    // Newton's iteration within a bracket, which is halved where a step would leave it.
    // Stops early if a bound shows that the tip stays below `least`.
    std::optional<Real> root(Bracket bracket, double least) const
    {
        auto& [low, t, high] = bracket;
        const double least_step = relative_rounding() * value_of(shape_.R);
        for (int k = 0; k < most_iterations && low < high; ++k) {
            const Slopes slopes = at(t);
            (slopes.value < Real{0} ? low : high) = t;
            if (slopes.bound(low, high) < least)
                return std::nullopt;
            Real next = slopes.rise > Real{0} ? t - slopes.value / slopes.rise : low;
            if (!(next > low && next < high))
                next = low + (high - low) / Real{2};
            const double step = std::abs(value_of(next - t));
            t = next;
            if (step <= least_step)
                break;
        }
        return t;
    }

    static constexpr double relative_rounding()
    {
        // a few bits are left for rounding errors
        constexpr double of_twice_the_digits = 1e-28;
        return std::is_same_v<Real, double> ? std::numeric_limits<double>::epsilon()
                                            : of_twice_the_digits;
    }

    // Enough to halve a bracket of either type down to its last digit, with Newton steps
    // in between.
    static constexpr int most_iterations = 300;

    const CutterShape<Real>& shape_;
    const RisingLine<Real>& line_;
};

}  // namespace endmill
