// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "endmill/machine/axis_limits.h"
#include "endmill/setup/detail/pole_points.h"

/// \file
/// Lower bounds of the rectangles of A,B about a tool axis while R1 turns within an
/// interval of azimuths. Directions may be 90 degrees or more from the tool axis.
/// Source: paper/notes/rectangle-about-an-axis.md, section 4.

namespace endmill {

/// An azimuth of R1 about the tool axis, with its cosine and sine.
struct R1Azimuth {
    double angle;   ///< rad
    double cosine;  ///< of the angle
    double sine;    ///< of the angle

    /// Computes cosine and sine. \param value rad.
    explicit R1Azimuth(double value)
        : angle{value},
          cosine{std::cos(value)},
          sine{std::sin(value)}
    {
    }

    /// sin beta of a direction with the coordinates x and y in PoleFrame.
    double along(double x, double y) const { return x * cosine + y * sine; }

    /// The value s with tan alpha = s / z, of a direction with the coordinates x, y and
    /// z.
    double across(double x, double y) const { return x * sine - y * cosine; }
};

/// Ranges of the two angles of a rectangle. Both contain 0.
struct RectangleExtents {
    RotaryRange alpha;  ///< rad, about R1
    RotaryRange beta;   ///< rad, about R2

    /// Area in rad^2.
    double area() const { return (alpha.to - alpha.from) * (beta.to - beta.from); }
};

/// Lower bounds for all rectangles with R1 in an interval of azimuths.
struct RectangleBound {
    /// Bound of each end, without the opposite of the tool axis.
    RectangleExtents extents;

    /// Lower bounds of the area, rad^2. If the opposite of the tool axis is one of the
    /// directions, it has alpha = 180 degrees in the first and -180 degrees in the
    /// second; otherwise both bounds are equal.
    std::array<double, 2> areas;
};

/// The directions that the rectangles about a tool axis must contain. They may lie
/// anywhere on the sphere.
class RectangleNeeds {
public:
    /// \pre the directions have unit length.
    explicit RectangleNeeds(const PolePoints& points);

    /// Azimuths of R1 within [0, pi], rad, at which the alpha of a direction jumps or
    /// passes 0 very quickly. An interval of azimuths must not contain one of them in its
    /// interior.
    const std::vector<double>& splits() const { return splits_; }

    /// Returns true if a direction is opposite to the tool axis, to 1e-9 rad. The range
    /// of alpha must then reach 180 degrees on one of its sides.
    bool has_opposite() const { return has_opposite_; }

    /// The extents with R1 at `azimuth`, without the opposite of the tool axis. A
    /// direction within 1e-9 rad of R1 or its opposite has alpha 0.
    /// \param azimuth of R1.
    /// \param beside an azimuth of the same interval. It decides the sign of alpha of
    ///         directions beyond 90 degrees, which is ambiguous at a split.
    RectangleExtents at(const R1Azimuth& azimuth, const R1Azimuth& beside) const;

    /// A lower bound for R1 between `left` and `right`, except where R1 is within 1e-9
    /// rad of a direction. If the same directions decide all extents over the whole
    /// interval, the gap to the least area is proportional to the square of the
    /// interval's width.
    /// \pre 0 < right - left <= pi, rad, without a split between them.
    RectangleBound over(const R1Azimuth& left, const R1Azimuth& right) const;

private:
    /// A direction at most 90 degrees from the tool axis.
    struct HighPoint {
        double x;
        double y;
        double inverse_z;

        bool is_along_r1(double across) const;
    };

    /// A direction more than 90 degrees from the tool axis, and not opposite to it.
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
