// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/removable_path.h"

#include <string>

#include "endmill/core/error.h"
#include "endmill/core/tolerance.h"

namespace endmill {
namespace {

// Differences of coordinates up to this size are still accurate to a thousandth of a
// millimetre.
constexpr double largest_coordinate = 1e9;  // mm

}  // namespace

void require_removable(const ToolPath& path)
{
    for (const PathPoint& point : path.points) {
        const Vec3& tip = point.location.tip;
        require(tip.allFinite() && tip.cwiseAbs().maxCoeff() <= largest_coordinate,
                "removal along a path: a tip is not within 1e9 mm");
        if (!((point.location.axis - Vec3::UnitZ()).norm() <= removal_axis_tolerance))
            throw GeometryError{
                "the tool axis of pass " + std::to_string(point.pass) + ", point " +
                std::to_string(point.point) +
                " is not +z: material is removed along 3-axis paths only"};
    }
}

bool cuts_at_start(const ToolPath& path)
{
    const Move move = path.points.front().move;
    return move == Move::Plunge || move == Move::Cut;
}

}  // namespace endmill
