// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// of R1 too. Derived in paper/notes/rectangle-about-an-axis.md.

#include <array>
#include <cmath>
#include <vector>

#include "endmill/machine/rotary_limits.h"
#include "endmill/setup/detail/pole_points.h"

namespace endmill {

/// An azimuth of R1 about the tool axis.
struct R1Azimuth {
    double angle;  ///< rad
    double cosine;
    double sine;

    /// \param value rad.
    explicit R1Azimuth(double value)
        : angle{value},
          cosine{std::cos(value)},
          sine{std::sin(value)}
    {
    }

    /// sin beta of a direction with these coordinates across the tool axis.
    double along(double x, double y) const { return x * cosine + y * sine; }

    /// s, such that tan alpha = s / z.
    double across(double x, double y) const { return x * sine - y * cosine; }
};

/// Ranges of both angles; each holds 0.
struct RectangleExtents {
    RotaryRange alpha;  ///< rad, about R1
    RotaryRange beta;   ///< rad, about R2

    /// rad^2.
    double area() const { return (alpha.to - alpha.from) * (beta.to - beta.from); }
};

/// What all rectangles of a piece need at least.
struct RectangleBound {
    RectangleExtents extents;  ///< each by itself, without the opposite of the tool axis

    /// rad^2, what the extents make or more: with the opposite of the tool axis, if it is one of
    /// the directions, at 180 and at -180 degrees of alpha; else twice the same.
    std::array<double, 2> areas;
};

/// The directions that rectangles about one tool axis are to hold, wherever they lie.
class RectangleNeeds {
public:
    /// \pre the directions have unit length.
    explicit RectangleNeeds(const PolePoints& points);

    /// Azimuths of R1, rad, from 0 to pi, at which an alpha jumps or passes 0 very quickly: a
    /// piece has none inside.
    const std::vector<double>& splits() const { return splits_; }

    /// Whether a direction lies opposite to the tool axis, to 1e-9 rad: alpha must then reach
    /// 180 degrees on one side, whichever.
    bool has_opposite() const { return has_opposite_; }

    /// With R1 at `azimuth`, directions beyond 90 degrees on the sides on which they are with R1
    /// at `beside`, without the one opposite to the tool axis. A direction within 1e-9 rad of R1
    /// or its opposite has alpha 0.
    RectangleExtents at(const R1Azimuth& azimuth, const R1Azimuth& beside) const;

    /// Over all azimuths from `left` to `right`, but where R1 is within 1e-9 rad of a direction.
    /// It falls short of the least area by a share of the square of the piece's width, where one
    /// and the same direction decides each extent all over the piece.
    /// \pre right - left is above 0 and at most pi, and no split lies between.
    RectangleBound over(const R1Azimuth& left, const R1Azimuth& right) const;

private:
    /// A direction less than 90 degrees from the tool axis, or just that.
    struct HighPoint {
        double x;
        double y;
        double inverse_z;

        bool is_along_r1(double across) const;
    };

    /// One beyond; not opposite to the tool axis.
    struct LowPoint {
        double x;
        double y;
        double rho;    ///< distance from the tool axis
        double depth;  ///< -z > 0

        bool is_along_r1(double across) const;
    };

    struct Extents;
    struct Ends;
    struct Support;
    struct LowSupport;
    struct Supports;

    Supports supports(const R1Azimuth& left, const R1Azimuth& right,
                      const R1Azimuth& middle) const;
    std::array<double, 2> areas_between(const Supports& supports, const R1Azimuth& middle,
                                        double half_width) const;
    static RectangleExtents ranges(const Extents& extents);

    std::vector<HighPoint> high_;
    std::vector<LowPoint> low_;
    std::vector<double> splits_;
    bool has_opposite_ = false;
};

}  // namespace endmill
