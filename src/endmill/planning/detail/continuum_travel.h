// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/judged_path.h"

namespace endmill {

/// Travel in mm that passes would have which lie as dense as the path interval asks, where
/// they need not be whole in number: the integral over the part of 1 / interval. Contact
/// lengths, without links.
struct ContinuumTravel {
    double iso;    ///< along plan.direction, each pass as near as its narrowest place
    double local;  ///< the same, as if every place had its own interval
    double best_direction;  ///< local, each place along its best direction
};

/// Of `surface`, by the interval of a ball for the curvature across the feed, at `samples`
/// by `samples` places. \pre a ball of plan.ball fits everywhere.
ContinuumTravel continuum_travel(const Surface& surface, const PlanToJudge& plan,
                                 int samples);

/// The same of parallel planes, each as near to the next as its narrowest place, over the
/// directions of the feed in the xy plane.
struct PlanarExtremes {
    double least;         ///< mm
    double least_at_deg;  ///< from +x
    double greatest;      ///< mm
};

/// Of feeds at multiples of 180 degrees / `directions`.
PlanarExtremes planar_extremes(const Surface& surface, const PlanToJudge& plan,
                               int directions, int samples);

}  // namespace endmill
