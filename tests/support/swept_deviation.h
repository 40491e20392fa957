// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "endmill/path/tool_path.h"
#include "endmill/surface/surface.h"
#include "endmill/surface/tool_side.h"

// The deviation that a ball's path leaves on surfaces, by brute force: samples of the
// surfaces, and the distance of each sample from every move.
namespace endmill::test {

/// A straight move of a ball's centre.
struct SampledMove {
    Vec3 from;
    Vec3 to;
};

/// Returns the moves of `path` on which the cutter may touch the part.
/// \param radius of the ball, mm.
inline std::vector<SampledMove> feed_moves(const ToolPath& path, double radius)
{
    std::vector<SampledMove> moves;
    for (std::size_t k = 0; k < path.points.size(); ++k) {
        const PathPoint& point = path.points[k];
        if (point.move == Move::Rapid || point.move == Move::Retract)
            continue;
        const auto centre = [&](const PathPoint& at) -> Vec3 {
            return at.location.tip + radius * at.location.axis;
        };
        moves.push_back({centre(point.move == Move::Plunge ? point : path.points[k - 1]),
                         centre(point)});
    }
    return moves;
}

/// Returns the distance of `point` from the move in mm, with a case for each end.
inline double distance_to(const Vec3& point, const SampledMove& move)
{
    const Vec3 along = move.to - move.from;
    if ((point - move.from).dot(along) <= 0)
        return (point - move.from).norm();
    if ((point - move.to).dot(along) >= 0)
        return (point - move.to).norm();
    return (point - move.from).cross(along).norm() / along.norm();
}

/// The extremes over all samples.
struct SweptDeviation {
    double gouge = 0;  ///< greatest depth of a sample in a ball, mm
    /// Greatest distance of a raised sample from all balls, mm.
    double beyond_height = -std::numeric_limits<double>::infinity();
};

/// Samples each surface at `count` + 1 by `count` + 1 places.
/// \param height by which samples are raised along the normal for `beyond_height`, mm.
inline SweptDeviation swept_deviation(std::span<const Surface> surfaces,
                                      const ToolPath& path, double radius, double height,
                                      int count)
{
    const std::vector<SampledMove> moves = feed_moves(path, radius);
    const Vec3 axis = path.points.front().location.axis;
    SweptDeviation result;
    for (const Surface& surface : surfaces) {
        const double side = tool_side_sign(surface, axis);
        const Interval u = surface.range(Parameter::U);
        const Interval v = surface.range(Parameter::V);
        for (int i = 0; i <= count; ++i)
            for (int j = 0; j <= count; ++j) {
                const double at_u = std::lerp(u.low, u.high, i / double(count));
                const double at_v = std::lerp(v.low, v.high, j / double(count));
                const auto normal =
                    limit_normal(surface.jet(at_u, at_v),
                                 {at_u < u.high ? 1 : -1, at_v < v.high ? 1 : -1});
                const Vec3 point = surface.tangents(at_u, at_v).point;
                const Vec3 raised = point + side * height * *normal;
                double nearest = radius;
                double raised_nearest = std::numeric_limits<double>::infinity();
                for (const SampledMove& move : moves) {
                    nearest = std::min(nearest, distance_to(point, move));
                    raised_nearest = std::min(raised_nearest, distance_to(raised, move));
                }
                result.gouge = std::max(result.gouge, radius - nearest);
                result.beyond_height =
                    std::max(result.beyond_height, raised_nearest - radius);
            }
    }
    return result;
}

}  // namespace endmill::test
