// SPDX-License-Identifier: GPL-3.0-or-later
// Rotation of parts and paths: the last functions of verification.h.
#include "endmill/verification/verification.h"

#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "endmill/core/tolerance.h"

namespace endmill {
namespace {

BezierPatch turned(const BezierPatch& patch, const Eigen::Matrix3d& rotation)
{
    std::vector<Eigen::Vector4d> net;
    for (int j = 0; j <= patch.degree(Parameter::V); ++j)
        for (int i = 0; i <= patch.degree(Parameter::U); ++i) {
            Eigen::Vector4d point = patch.homogeneous_point(i, j);
            point.head<3>() = rotation * point.head<3>().eval();
            net.push_back(point);
        }
    return BezierPatch::from_homogeneous(
        patch.degree(Parameter::U), patch.degree(Parameter::V), net, patch.is_rational());
}

Surface turned(const Surface& surface, const Eigen::Matrix3d& rotation)
{
    std::vector<BezierPatch> patches;
    for (int j = 0; j < surface.patches(Parameter::V); ++j)
        for (int i = 0; i < surface.patches(Parameter::U); ++i)
            patches.push_back(turned(surface.patch(i, j), rotation));
    const auto breaks = [&](Parameter along) {
        const auto all = surface.breaks(along);
        return std::vector<double>(all.begin(), all.end());
    };
    return {breaks(Parameter::U), breaks(Parameter::V), std::move(patches),
            surface.tool_side()};
}

}  // namespace

std::optional<Vec3> fixed_axis(const ToolPath& path)
{
    if (path.points.empty())
        return Vec3::UnitZ();
    const Vec3 axis = path.points.front().location.axis;
    for (const PathPoint& point : path.points)
        if ((point.location.axis - axis).norm() > unit_vector_rounding)
            return std::nullopt;
    return axis;
}

Eigen::Matrix3d upright_rotation(const Vec3& axis)
{
    if (axis == Vec3::UnitZ())
        return Eigen::Matrix3d::Identity();
    return Eigen::Quaterniond::FromTwoVectors(axis, Vec3::UnitZ()).toRotationMatrix();
}

Part turned(const Part& part, const Eigen::Matrix3d& rotation)
{
    if (const auto* mesh = std::get_if<TriangleMesh>(&part)) {
        std::vector<Vec3> points;
        for (const Vec3& point : mesh->points())
            points.emplace_back(rotation * point);
        return TriangleMesh{std::move(points),
                            {mesh->triangles().begin(), mesh->triangles().end()}};
    }
    std::vector<Surface> surfaces;
    for (const Surface& surface : std::get<std::vector<Surface>>(part))
        surfaces.push_back(turned(surface, rotation));
    return surfaces;
}

ToolPath turned(const ToolPath& path, const Eigen::Matrix3d& rotation)
{
    ToolPath result = path;
    for (PathPoint& point : result.points) {
        point.location.tip = rotation * point.location.tip;
        // The shared axis becomes exactly +z, as the removal requires.
        const Vec3 axis = rotation * point.location.axis;
        point.location.axis = (axis - Vec3::UnitZ()).norm() <= 2 * unit_vector_rounding
                                  ? Vec3::UnitZ()
                                  : axis;
        if (const SurfaceContact* known = point.contact()) {
            SurfaceContact contact = *known;
            contact.contact.point = rotation * contact.contact.point;
            contact.contact.normal = rotation * contact.contact.normal;
            point.known_contact = contact;
        } else if (const Vec3* normal = point.normal()) {
            const Vec3 rotated = rotation * *normal;
            point.known_contact = rotated;
        }
    }
    return result;
}

}  // namespace endmill
