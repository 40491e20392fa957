// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/path/tool_path.h"

namespace endmill {

/// How a machine follows a path.
struct FeedAcceleration {
    double acceleration_mm_per_s2;  ///< along the path, and across it in corners; above 0
    double corner_tolerance_mm = 0.01;  ///< by which a corner may be cut; above 0
};

/// The motion along a polyline, from rest to rest.
struct PlannedRun {
    std::vector<double> vertex_speeds;  ///< mm/s, at each point
    std::vector<double> segment_times;  ///< s, of each segment
    double time_s = 0;                  ///< their sum, in order
};

/// Fastest speed in mm/s over the corner from `before` to `after`, two moves with the corner
/// between them: that of the circle which touches both, passes within the tolerance of the
/// corner and uses no more than half of either move. Infinite if the direction stays, 0 if
/// it is reversed.
/// Source: spec of ball-end milling, section 11; with half the turn's cosine c and sine s,
/// radius = min(tolerance c (1 + c) / s^2, c / (2 s) least length), speed^2 = a radius.
/// \param before, after in mm, of any length but 0.
/// \throws DomainError unless tolerance and acceleration are as said and no length is 0.
double corner_speed(const Vec3& before, const Vec3& after,
                    const FeedAcceleration& motion);

/// Fastest motion along `points` whose speed is nowhere above that of its segment, nor at
/// a point above the corner's, and changes no faster than the acceleration. Each speed at a
/// point is the largest that both neighbours allow, so no motion within these bounds takes
/// less time.
/// Source: spec of ball-end milling, section 11.
///
/// \param points in mm. \param feeds in mm/s, one a segment, above 0.
/// \throws DomainError unless there are two points, finite and no two neighbours equal,
///         and feeds and motion are as said.
/// Relative error of the time below 1e-13 a segment. Linear in the points.
PlannedRun planned_run(std::span<const Vec3> points, std::span<const double> feeds,
                       const FeedAcceleration& motion);

/// Times in s of the moves of `path`, one a point, that to the first 0. Each run of moves at
/// feed is planned by its tips from rest to rest; a rapid, and what else but a cut has no
/// feed, has 0 and makes the machine rest before and after. A move that goes nowhere has 0.
/// \throws DomainError unless every cut has a feed; or as `planned_run`.
std::vector<double> planned_times(const ToolPath& path, const FeedAcceleration& motion);

}  // namespace endmill
