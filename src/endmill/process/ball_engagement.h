// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// \file
/// The cut of a ball-end mill on one straight move, given by ratios and angles. All
/// functions of this module that compute forces take it as input.

namespace endmill {

/// The material that was cut before the present pass, seen across the feed.
enum class PreviousPass {
    Beside,  ///< a parallel pass, at the distance of the pick feed
    None,    ///< nothing: a full slot, with stock on both sides
    Edge     ///< nothing, and the ball centre is above the edge of the block
};

/// Side of the feed on which the stock lies, for a spindle that turns clockwise seen from
/// above (M03).
enum class Milling {
    Up,   ///< conventional milling: stock to the left of the feed, the chip begins thin
    Down  ///< climb milling: stock to the right of the feed, the chip ends thin
};

/// Definition of the chip thickness.
enum class ChipModel {
    Paper,  ///< feed per tooth times |sin(azimuth)|, measured horizontally
    Exact   ///< component of the feed per tooth normal to the ball
};

/// Engagement of a ball-end mill on a straight move. All lengths are in radii of the
/// ball.
///
/// Frame: the origin is the ball centre, X is the horizontal projection of the feed, Z is
/// the spindle axis and points up, Y is horizontal and points towards the uncut stock.
/// Source: [ParkMaeng, section 2.2]. The paper does not state its frame and signs; they
/// are derived in paper/notes/ball-engagement.md and
/// docs/methods/ball-end-milling.md, section 1.
struct BallEngagement {
    /// Slope of the pick feed in rad: its rise towards the stock, turned about the feed.
    /// |mu| < pi/2.
    double mu;
    double lambda;  ///< slope of the feed in rad, positive uphill; |lambda| < pi/2
    /// Distance from the axis of the previous pass, at least 0. Ignored unless `previous`
    /// is PreviousPass::Beside.
    double pick_feed_ratio;
    /// Height of the stock's horizontal top above the tip. The cutter is in air if it is
    /// 0 or less.
    double depth_ratio;
    PreviousPass previous = PreviousPass::Beside;  ///< what has been cut before
};

/// Checks the ranges that BallEngagement states.
/// \throws DomainError if an angle or a ratio is outside its range or not finite.
void require_sound(const BallEngagement& engagement);

/// True if the cutter removes nothing: it is above the stock, or its distance to the
/// previous pass is 0.
bool is_air(const BallEngagement& engagement);

/// Angle in rad over which the shank above the ball cuts, measured from Y towards X:
/// acos(1 - R_p cos(mu)), at most pi, beside a previous pass, pi in a slot, pi/2 at an
/// edge.
/// Source: [ParkMaeng, eq. (2)].
/// \pre `engagement` is sound.
double shank_angle(const BallEngagement& engagement);

}  // namespace endmill
