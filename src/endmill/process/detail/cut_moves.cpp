// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/detail/cut_moves.h"

#include <cmath>
#include <limits>
#include <string>

#include "endmill/core/detail/large_pages.h"
#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/core/text.h"
#include "endmill/core/tolerance.h"

namespace endmill {
namespace {

// Least horizontal share of a direction. Below it, rounding dominates the azimuth of the
// feed.
constexpr double least_horizontal_share = 1e-6;

void require_upright(const ToolPath& path)
{
    parallel_for(path.points.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Vec3& axis = path.points[i].location.axis;
            if (!((axis - Vec3::UnitZ()).norm() <= cutting_axis_tolerance))
                throw GeometryError{
                    "the axis of point " + std::to_string(i) + " is " +
                    to_text(axis.x()) + "," + to_text(axis.y()) + "," +
                    to_text(axis.z()) +
                    "; expected 0,0,1: the model describes vertical axes only"};
        }
    });
}

// Whether a move is vertical up to rounding.
bool is_upright(const Vec3& way, double length)
{
    return std::hypot(way.x(), way.y()) < least_horizontal_share * length;
}

}  // namespace

std::vector<CutMove> cut_moves(const ToolPath& path)
{
    require_upright(path);
    require(path.points.size() <= std::numeric_limits<std::uint32_t>::max(),
            "cut_moves: need a path whose points 32 bits can number");
    std::vector<CutMove> moves;
    reserve_in_large_pages(moves, path.points.size());
    double along = 0;
    for (std::size_t i = 1; i < path.points.size(); ++i) {
        const PathPoint& end = path.points[i];
        const Vec3& from = path.points[i - 1].location.tip;
        const Vec3& to = end.location.tip;
        const double length = (to - from).norm();
        if (end.move == Move::Cut && length > 0 && !is_upright(to - from, length))
            moves.push_back({&end, static_cast<std::uint32_t>(i), along, length});
        along += length;
    }
    return moves;
}

std::size_t zero_length_cuts(const ToolPath& path)
{
    std::size_t count = 0;
    for (std::size_t i = 1; i < path.points.size(); ++i)
        if (path.points[i].move == Move::Cut &&
            path.points[i].location.tip == path.points[i - 1].location.tip)
            ++count;
    return count;
}

}  // namespace endmill
