// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "endmill/core/vec.h"

namespace endmill {

/// A point of a curve with its derivatives.
struct CurveJet {
    Vec3 point;   ///< mm
    Vec3 first;   ///< mm per unit of the parameter
    Vec3 second;  ///< mm per unit of the parameter squared
};

/// Cubic Bezier curves end to end. Piece i covers the parameters i to i + 1; outside the range the
/// polynomials of the end pieces are continued. An immutable value.
class CompositeCurve {
public:
    /// \param points 3 n + 1 control points in mm of n pieces; neighbours share a point.
    /// \throws DomainError if the number is wrong or a point is not finite.
    explicit CompositeCurve(std::vector<Vec3> points);

    int pieces() const { return static_cast<int>(coefficients_.size()); }  ///< at least 1
    double end() const { return pieces(); }  ///< last parameter; the first is 0
    std::span<const Vec3> points() const { return points_; }  ///< control points, mm

    Vec3 point(double t) const;    ///< the point at t
    CurveJet jet(double t) const;  ///< the jet at t; of the piece above at a joint

    /// The smallest t > `from` with (point(t) - point(from)) . direction = distance.
    /// Source: [KimChoi, eq. (3)].
    /// \param from      start of the search.
    /// \param direction unit.
    /// \param distance  in mm, positive.
    /// \return t, with a residual of a few roundings of the curve's size; nothing if the curve
    ///         does not reach that distance.
    std::optional<double> first_reach(double from, const Vec3& direction,
                                      double distance) const;

private:
    // A piece as c0 + t (c1 + t (c2 + t c3)) with t from 0 to 1.
    struct Cubic {
        Vec3 c0, c1, c2, c3;
    };

    int piece_number(double t) const;

    std::vector<Vec3> points_;
    std::vector<Cubic> coefficients_;
};

/// The same curve with t replaced by end - t.
CompositeCurve reversed(const CompositeCurve& curve);

}  // namespace endmill
