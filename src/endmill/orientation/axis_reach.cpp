// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/orientation/axis_reach.h"

#include <algorithm>
#include <utility>

#include "endmill/drop_cutter/clearance.h"
#include "endmill/verification/verification.h"

namespace endmill {
namespace {

// A place faces away from an axis if its normal has less than this along the axis; the module
// deviation judges the same facets.
constexpr double least_along_axis = -1e-9;

}  // namespace

AxisReach::AxisReach(const TriangleMesh& part, const Cutter& cutter,
                     std::span<const Vec3> axes)
{
    stands_.reserve(axes.size());
    for (const Vec3& axis : axes) {
        const Eigen::Matrix3d rotation = upright_rotation(axis);
        std::vector<Vec3> points;
        points.reserve(part.points().size());
        for (const Vec3& point : part.points())
            points.emplace_back(rotation * point);
        auto mesh = std::make_shared<const TriangleMesh>(
            std::move(points),
            std::vector<Triangle>{part.triangles().begin(), part.triangles().end()});
        auto drop_cutter = std::make_shared<const DropCutter>(*mesh, cutter);
        stands_.push_back({rotation, std::move(mesh), std::move(drop_cutter)});
    }
}

bool AxisReach::reaches(std::size_t axis, const CutterContact& place,
                        double distance) const
{
    const Stand& stand = stands_[axis];
    CutterContact upright{stand.rotation * place.point, stand.rotation * place.normal};
    // The normal of a wall may point down by rounding.
    const bool faces_tool = upright.normal.z() > least_along_axis;
    upright.normal.z() = std::max(upright.normal.z(), 0.0);
    return faces_tool && is_accessible(*stand.drop_cutter, upright, distance);
}

bool AxisReach::reaches(const CutterContact& place, double distance) const
{
    for (std::size_t axis = 0; axis < stands_.size(); ++axis)
        if (reaches(axis, place, distance))
            return true;
    return false;
}

}  // namespace endmill
