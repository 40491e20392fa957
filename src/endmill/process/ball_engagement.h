// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "endmill/core/vec.h"

namespace endmill {

/// What the cutter meets across the feed.
enum class PreviousPass {
    Beside,  ///< a parallel pass, one pick feed back, has taken its share
    None,    ///< a slot: full stock on both sides
    Edge     ///< the first pass, ball centre over the block's edge: stock on one side
};

/// How a ball-end cutter on a straight move stands in the stock, in radii of the ball.
///
/// The ball's centre is the origin; X is the feed as seen from above, Z the spindle's axis,
/// upwards, Y horizontal towards the uncut stock. Lengths are ratios to the ball's radius.
/// Source: [ParkMaeng, section 2.2]; frame and signs, which the print does not state, are
/// derived in paper/notes/ball-engagement.md.
struct BallEngagement {
    double mu;      ///< rad, slope across the feed: the pick feed, turned about the
                    ///< feed, rises by it towards the stock; below pi/2 either way
    double lambda;  ///< rad, slope of the feed, positive uphill; below pi/2 either way
    double
        pick_feed_ratio;  ///< distance from the previous pass; >= 0. Only read with Pass
    double
        depth_ratio;  ///< from the tip up to the stock's horizontal top; at most 0: air
    PreviousPass previous = PreviousPass::Beside;  ///< what has been cut before
};

/// A range of azimuths on the cutter in which its edges cut.
struct AzimuthRange {
    double from;  ///< rad, from Y, across the feed to the stock, towards X, the feed;
    double to;    ///< -pi/2 <= from < to <= 3 pi/2
};

/// Throws DomainError unless angles and ratios lie in the ranges that BallEngagement states.
void require_sound(const BallEngagement& engagement);

/// Whether nothing is cut: above the stock, or with no distance to the previous pass.
bool is_air(const BallEngagement& engagement);

/// Whether the point of the ball at `latitude` (rad from the tip, 0 … pi/2) and `azimuth`
/// (rad, as in AzimuthRange) cuts: it faces the feed, the previous pass has left it, and it
/// is below the stock's top. The previous pass is what the ball's lower half and all above
/// it cleared. Source: derived in paper/notes/ball-engagement.md, (a), (b), (c).
/// \pre `engagement` is sound.
bool is_engaged(const BallEngagement& engagement, double latitude, double azimuth);

/// The azimuths that cut at `latitude`, rising and apart from each other; a full ring is
/// one range. Ends are roots of closed quartics, good to 1e-12 where the border crosses the
/// ring and to 1e-7 where it touches it. Source: paper/notes/ball-engagement.md, section 2.
/// \param latitude rad from the tip, 0 < latitude <= pi/2.
/// \throws DomainError for another latitude, or unless `engagement` is sound.
std::vector<AzimuthRange> engaged_ranges(const BallEngagement& engagement,
                                         double latitude);

/// Angle in rad, 0 … pi, from Y towards X, over which the shank above the ball cuts: with a
/// previous pass acos(1 - R_p cos(mu)), in a slot pi, at an edge pi/2.
/// Source: [ParkMaeng, eq. (2)].
/// \pre `engagement` is sound.
double shank_angle(const BallEngagement& engagement);

/// Angle in rad, 0 … 2 pi, over which a point of the edge cuts in a turn at the height of the
/// stock's top, or where the shank begins if the stock is higher: phi of the tool's life.
/// Source: [ParkMaeng, eq. (4)]; which phi is our choice.
/// \throws DomainError unless `engagement` is sound.
double engaged_angle(const BallEngagement& engagement);

/// A kind of line on the ball that borders what is engaged; the stock's top, a circle of
/// latitude, is another.
enum class BorderKind {
    Front,         ///< the great circle across the feed
    PreviousBall,  ///< where the lower half of the previous pass meets the ball
    Wall  ///< an upright plane along the feed: side of the previous pass, or edge
};

/// A stretch of a border. Its parameter is p = tan(x/2), |p| <= 1, x an angle:
///
///     Front          P = (cos x sin lambda, -sin x, -cos x cos lambda)
///     Wall at y      P = (rho sin x, y, -rho cos x),  rho^2 = 1 - y^2
///     PreviousBall   x the amplitude of a pendulum: sin(nu/2) = k sin x with nu the angle
///                    about the previous pass's axis, from its farthest point in front
///
/// so that points on it, and their derivatives, are analytic also where a border leaves the
/// front. It runs so that the engaged side is on its right, seen along the feed.
/// Source: derived in paper/notes/ball-engagement.md, section 1.
struct BorderArc {
    BorderKind kind;
    double from;  ///< p at its begin
    double to;    ///< p at its end; less than `from` on Front and Wall
};

/// A point of a border, and its rates as p grows.
struct BorderPoint {
    Vec3 at;
    double turn;    ///< Y dX - X dY: of the azimuth, times sin^2 of the latitude
    double height;  ///< dZ, a dp
};

/// The engaged region of a ball on a straight move, seen by its borders.
/// Lengths in radii of the ball, in the frame of BallEngagement.
/// Source: derived in paper/notes/ball-engagement.md, sections 1 and 2.
struct EngagedRegion {
    /// \pre `engagement` is sound and no air.
    explicit EngagedRegion(const BallEngagement& engagement);

    /// Whether the point faces the feed and the previous pass has left it; it may be above
    /// the stock's top.
    bool has(const Vec3& point) const;

    /// Whether the previous pass has left the point, wherever it is on the ball.
    bool previous_left(const Vec3& point) const;

    /// The azimuths engaged at a latitude of this sine and cosine, be it above the top.
    std::vector<AzimuthRange> ranges_at(double sine, double cosine) const;

    /// The borders below the top but for that itself. With `split_at_axis` none of them goes
    /// from in front of the axis (X > 0) to behind it.
    std::vector<BorderArc> borders(bool split_at_axis) const;

    /// The point of the ball on a border.
    Vec3 point(BorderKind kind, double p) const;

    /// The same with its rates.
    BorderPoint moving_point(BorderKind kind, double p) const;

    /// p at which PreviousBall passes the axis, y = 0; its nearest end if it does not.
    double beside_axis() const;

    /// Whether a border is at one azimuth throughout, and so adds nothing to an integral over it.
    bool is_radial(BorderKind kind) const;

    PreviousPass previous;
    double cos_lambda;
    double sin_lambda;
    double cos_mu;
    double sin_mu;
    double pick_feed;   ///< R_p; 0 without a previous pass
    double across;      ///< a, its part along Y
    double rise;        ///< b, its part normal to the feed, upwards
    double top_cosine;  ///< of the latitude to which the ball is in the stock
    double top_sine;    ///< of the same
    double depth;       ///< 1 - top_cosine: depth of the ball in the stock, at most 1
    double wall;        ///< y of Wall; 1 or more: there is none on the ball
    double amplitude;   ///< k of PreviousBall
    double reach;       ///< how far the front of PreviousBall is from the front plane
    double first;       ///< p at which PreviousBall begins, at the wall; 1: there is none
};

}  // namespace endmill
