// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/setup_figures.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "endmill/core/error.h"

// Directions of the tool are known in coordinates of the part. Figures show them in
// coordinates of the machine, where the axes are fixed: every direction and point is
// multiplied by the rotation `part_to_machine`.

namespace endmill {
namespace {

constexpr double rotation_tolerance = 1e-9;  // of products of rows; searches round them
constexpr double sphere_room = 1.1;          // keeps borders away from the part
constexpr double least_radius = 1e-12;       // mm; a smaller part is a single point

// Adds the border of a set as lines of an object.
void add_borders(std::vector<SetupLine>& lines, SetupObject object,
                 const FeasibleDirections& set, double step)
{
    for (DirectionCurve& curve : set.border(step))
        lines.push_back({object, std::move(curve)});
}

}  // namespace

// Directions are normalised, because the rotation may be rounded.
RotaryFrame machine_directions(const ShownSetup& setup)
{
    const Eigen::Matrix3d& turn = setup.part_to_machine;
    require((turn * turn.transpose()).isIdentity(rotation_tolerance) &&
                turn.determinant() > 0,
            "machine_directions: need a rotation from part to machine");
    return {setup.frame.family, (turn * setup.frame.tool_axis).normalized(),
            (turn * setup.frame.r1_axis).normalized(),
            (turn * setup.frame.r2_axis).normalized()};
}

std::vector<SetupLine> motion_borders(const ShownSetup& setup, double step)
{
    const RotaryFrame frame = machine_directions(setup);
    std::vector<SetupLine> lines;
    add_borders(lines, SetupObject::NeededMotion, {frame, setup.needed}, step);
    if (setup.limits)
        add_borders(lines, SetupObject::MachineMotion, {frame, *setup.limits}, step);
    return lines;
}

std::vector<Vec3> posed_points(const TriangleMesh& mesh, const ShownSetup& setup)
{
    std::vector<Vec3> points;
    points.reserve(mesh.points().size());
    for (const Vec3& point : mesh.points())
        points.emplace_back(setup.part_to_machine * point);
    return points;
}

// The centre is that of the bounding box, which does not depend on the density of the
// points.
PartSphere sphere_around(const std::vector<Vec3>& points)
{
    require(!points.empty(), "sphere_around: need a point");
    Eigen::AlignedBox3d box;
    for (const Vec3& point : points)
        box.extend(point);
    const Vec3 centre = box.center();
    double farthest = 0;
    for (const Vec3& point : points)
        farthest = std::max(farthest, (point - centre).norm());
    return {centre, farthest > least_radius ? sphere_room * farthest : 1};
}

std::vector<std::uint8_t> reached_at_zero(const SphereGrid& grid,
                                          const VisibilityMap& map, const Vec3& tool_axis)
{
    const auto nearest = std::ranges::max_element(
        grid.centres, {}, [&](const Vec3& centre) { return centre.dot(tool_axis); });
    const auto cell = static_cast<std::size_t>(nearest - grid.centres.begin());
    std::vector<std::uint8_t> reached;
    reached.reserve(map.facets());
    for (std::size_t facet = 0; facet < map.facets(); ++facet)
        reached.push_back(map.is_accessible(facet, cell) ? 1 : 0);
    return reached;
}

std::string axis_label(SetupObject object, const RotaryFrame& machine_directions)
{
    if (object == SetupObject::ToolAxis)
        return "tool axis";
    const bool is_first = object == SetupObject::FirstAxis;
    const Vec3& axis = is_first ? machine_directions.r1_axis : machine_directions.r2_axis;
    Eigen::Index letter = 0;
    axis.cwiseAbs().maxCoeff(&letter);
    return std::string{is_first ? "R1 = " : "R2 = "} + "ABC"[letter];
}

}  // namespace endmill
