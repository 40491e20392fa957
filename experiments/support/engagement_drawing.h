// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "support/ball_drawing.h"

namespace endmill {

/// The ball in its cut as an SVG file: its engaged part, the previous pass, feed T, normal N,
/// pick feed F_p, the frame X, Y, Z, and the angles between them.
/// Source: the manner of [ParkMaeng, fig. 2].
/// \param captions below the title.
std::string engagement_svg(const BallEngagement& engagement, const BallFrame& frame,
                           const std::vector<std::string>& captions);

}  // namespace endmill
