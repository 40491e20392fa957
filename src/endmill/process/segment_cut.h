// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "endmill/process/ball_engagement.h"
#include "endmill/process/cutting_force.h"

namespace endmill {

/// How a ball-end mill stands in the material on one straight cutting move: geometry at the
/// middle of the move. What is not known, or has no meaning for a first pass, is none.
/// Source: [ParkMaeng, eq. (8) to (14)]; spec of ball-end milling, sections 1, 3, 6.
struct SegmentCut {
    int pass = 0;                   ///< as in the path
    int point = 0;                  ///< as in the path: that to which the move leads
    double length_mm = 0;           ///< of the move of the ball's centre, above 0
    std::optional<double> mu = {};  ///< rise of the pick feed about the feed, rad
    double lambda = 0;              ///< rise of the feed, rad
    std::optional<double> pick_feed_mm = {};             ///< f_p, between the centres
    std::optional<double> pick_feed_horizontal_mm = {};  ///< f_p cos(mu)
    double depth_mm = 0;  ///< l, stock's top over the tip; 0 or less: in air
    PreviousPass previous = PreviousPass::Beside;  ///< needs mu and the pick feed
    Milling milling = Milling::Down;
    bool has_two_neighbours =
        false;  ///< an earlier pass on the other side too, further off
};

}  // namespace endmill
