// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/core/vec.h"
#include "endmill/process/ball_engagement.h"
#include "endmill/process/detail/previous_pass.h"

namespace endmill {

/// A range of azimuths on the cutter in which its edges cut.
struct AzimuthRange {
    double from;  ///< rad, measured from Y (towards the stock) towards X (the feed)
    double to;    ///< rad; -pi/2 <= from < to <= 3 pi/2
};

/// Kinds of curves on the ball that border the engaged region. The stock's top, a circle
/// of latitude, is a further border.
enum class BorderKind {
    Front,         ///< the great circle across the feed
    PreviousBall,  ///< where the lower half of the previous pass meets the ball
    Wall  ///< a vertical plane along the feed: side of the previous pass, or edge
};

/// Whether borders are split where they cross X = 0, the plane across the feed through
/// the axis.
enum class BorderSplit {
    Whole,  ///< borders may cross X = 0
    AtAxis  ///< no border has points on both sides of X = 0
};

/// An arc of a border. Its parameter is p = tan(x/2), |p| <= 1, where x is an angle:
///
///     Front          P = (cos x sin lambda, -sin x, -cos x cos lambda)
///     Wall at y      P = (rho sin x, y, -rho cos x),  rho^2 = 1 - y^2
///     PreviousBall   the curve of PreviousPassCurve
///
/// Points and their derivatives are analytic in p over the whole arc. The arc runs so
/// that the engaged side is on its right, seen along the feed.
/// Source: derived in paper/notes/ball-engagement.md, section 1.
struct BorderArc {
    BorderKind kind;
    double from;  ///< p at the beginning
    double to;    ///< p at the end; less than `from` on Front and Wall
};

/// A point of a border with its derivatives by p.
struct BorderPoint {
    Vec3 at;      ///< in radii of the ball
    double turn;  ///< Y dX/dp - X dY/dp: rate of the azimuth times sin^2 of the latitude
    double height;  ///< dZ/dp
};

/// The part of a ball that cuts on a straight move, described by its borders.
///
/// A point of the ball cuts if it faces the feed, if the previous pass has not removed
/// the material there, and if it lies below the stock's top. The previous pass has
/// removed everything in the lower half of its ball's cylinder and above it. Lengths are
/// in radii of the ball, in the frame of BallEngagement.
/// Source: derived in paper/notes/ball-engagement.md, sections 1 and 2.
struct EngagedRegion {
    /// \pre `engagement` is sound and not in air.
    explicit EngagedRegion(const BallEngagement& engagement);

    /// Whether `point` faces the feed and lies in material that the previous pass has
    /// left. The stock's top is not considered.
    bool has(const Vec3& point) const;

    /// Whether the previous pass has left material at `point`.
    bool previous_left(const Vec3& point) const;

    /// The engaged azimuths at the latitude with this sine and cosine, ascending and
    /// disjoint. The stock's top is not considered. A full ring is one range.
    std::vector<AzimuthRange> ranges_at(double sine, double cosine) const;

    /// The borders below the stock's top, without the top itself.
    std::vector<BorderArc> borders(BorderSplit split) const;

    /// The point of a border at the parameter `p`.
    Vec3 point(BorderKind kind, double p) const;

    /// The point of a border at the parameter `p`, with its derivatives.
    BorderPoint moving_point(BorderKind kind, double p) const;

    /// Parameter p at which PreviousBall crosses y = 0, or its nearest end if it does
    /// not.
    double beside_axis() const;

    /// Whether the azimuth is constant along a border of this kind. An integral over the
    /// azimuth along such a border is 0.
    bool is_radial(BorderKind kind) const;

    PreviousPass previous;   ///< what has been cut before
    PreviousPassCurve pass;  ///< the border with the previous pass
    double cos_lambda;       ///< cosine of the slope of the feed
    double sin_lambda;       ///< sine of the slope of the feed
    double top_cosine;  ///< cosine of the latitude up to which the ball is in the stock
    double top_sine;    ///< sine of the same latitude
    double depth;       ///< 1 - top_cosine: depth of the ball in the stock, at most 1
    double wall;        ///< y of Wall; 1 or more if there is none on the ball
    SignChanges below_top;  ///< where PreviousBall crosses the latitude of `top_cosine`
};

/// Whether the point of the ball at `latitude` (rad from the tip, 0 to pi/2) and
/// `azimuth` (rad, as in AzimuthRange) cuts.
/// Source: derived in paper/notes/ball-engagement.md, conditions (a), (b), (c).
/// \pre `engagement` is sound.
bool is_engaged(const BallEngagement& engagement, double latitude, double azimuth);

/// The azimuths that cut at `latitude`, ascending and disjoint. A full ring is one range.
/// The ends are roots of quartics with closed coefficients: accurate to 1e-12 where the
/// border crosses the circle of latitude, and to 1e-7 where it touches it.
/// Source: paper/notes/ball-engagement.md, section 2.
/// \param engagement the cut.
/// \param latitude rad from the tip, 0 < latitude <= pi/2.
/// \throws DomainError for another latitude, or unless `engagement` is sound.
std::vector<AzimuthRange> engaged_ranges(const BallEngagement& engagement,
                                         double latitude);

}  // namespace endmill
