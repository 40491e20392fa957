// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

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

}  // namespace endmill
