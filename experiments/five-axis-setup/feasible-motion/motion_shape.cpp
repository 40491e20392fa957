// SPDX-License-Identifier: GPL-3.0-or-later
#include "five-axis-setup/feasible-motion/motion_shape.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include "endmill/core/angle.h"
#include "endmill/machine/kinematics.h"

namespace endmill {
namespace {

constexpr double rounding = 1e-9;  // of sampled curves, radii of the sphere

double length(const DirectionCurve& curve)
{
    double sum = 0;
    for (std::size_t k = 1; k < curve.size(); ++k)
        sum += angle_between(curve[k - 1], curve[k]);
    return sum;
}

// Root mean square distance of the points from the best plane through the centre.
double off_great_circle(const DirectionCurve& curve)
{
    Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
    for (const Vec3& point : curve)
        moments += point * point.transpose();
    // The root of the least eigenvalue would lose half of the digits, so the distances
    // are taken from the points.
    const Vec3 normal =
        Eigen::JacobiSVD<Eigen::Matrix3d>{moments, Eigen::ComputeFullU}.matrixU().col(2);
    double sum = 0;
    for (const Vec3& point : curve)
        sum += std::pow(point.dot(normal), 2);
    return std::sqrt(sum / static_cast<double>(curve.size()));
}

bool is_parallel(const DirectionCurve& curve, const Vec3& axis)
{
    const double first = curve.front().dot(axis);
    return std::abs(first) > rounding &&
           std::ranges::all_of(curve, [&](const Vec3& point) {
               return std::abs(point.dot(axis) - first) < rounding;
           });
}

// Whether each cell, in the order of its angle with the axis, belongs to the set.
std::vector<bool> membership(const FeasibleDirections& set, std::span<const Vec3> cells,
                             const Vec3& axis)
{
    std::vector<Vec3> in_order{cells.begin(), cells.end()};
    std::ranges::sort(in_order, std::greater<>{},
                      [&](const Vec3& cell) { return cell.dot(axis); });
    std::vector<bool> is_in;
    is_in.reserve(in_order.size());
    for (const Vec3& cell : in_order)
        is_in.push_back(set.contains(cell));
    return is_in;
}

std::int64_t changes(const std::vector<bool>& is_in)
{
    std::int64_t count = 0;
    for (std::size_t k = 1; k < is_in.size(); ++k)
        count += is_in[k] != is_in[k - 1] ? 1 : 0;
    return count;
}

std::string shape(const FeasibleDirections& set, std::span<const Vec3> cells,
                  double border_length)
{
    if (set.solid_angle() == 0)
        return border_length < rounding ? "point" : "arc";
    const std::vector<bool> by_tilt = membership(set, cells, set.frame().tool_axis);
    if (by_tilt.front() && changes(by_tilt) == 1)
        return "disc";
    const std::vector<bool> by_latitude = membership(set, cells, set.frame().r1_axis);
    const bool is_between = !by_latitude.front() && !by_latitude.back();
    return is_between && changes(by_latitude) == 2 ? "band" : "other";
}

std::int64_t asymmetric(const FeasibleDirections& set, std::span<const Vec3> cells)
{
    const Vec3& axis = set.frame().tool_axis;
    return std::ranges::count_if(cells, [&](const Vec3& cell) {
        const Vec3 image = 2 * axis.dot(cell) * axis - cell;
        return set.contains(cell) && !set.contains(image);
    });
}

}  // namespace

std::vector<std::string> motion_columns()
{
    return {"solid_angle_sr",   "edges",           "great_edges",
            "parallel_edges",   "length_deg",      "length_off_deg",
            "r1_tool_deg",      "r2_tool_deg",     "shape",
            "off_great_circle", "asymmetric_cells"};
}

NamedCells motion_cells(const MachineConfiguration& machine,
                        const FeasibleDirections& set, double border_step,
                        std::span<const Vec3> cells)
{
    const auto border = set.border(border_step);
    const auto degrees = [](double angle) { return Angle::radians(angle).degrees(); };
    double sum = 0;
    double off = 0;
    std::int64_t great = 0;
    std::int64_t parallel = 0;
    for (const DirectionCurve& curve : border) {
        sum += length(curve);
        off = std::max(off, off_great_circle(curve));
        great += off_great_circle(curve) < rounding ? 1 : 0;
        parallel += is_parallel(curve, set.frame().r1_axis) ? 1 : 0;
    }
    NamedCells found{{"solid_angle_sr", set.solid_angle()},
                     {"edges", static_cast<std::int64_t>(border.size())},
                     {"great_edges", great},
                     {"parallel_edges", parallel},
                     {"length_deg", degrees(sum)},
                     {"shape", shape(set, cells, sum)},
                     {"off_great_circle", off}};
    const RotaryRange& phi = set.limits().phi;
    if (machine.axes() == 4)
        found.emplace_back("length_off_deg",
                           degrees(std::abs(sum - (phi.to - phi.from))));
    if (machine.axes() < 5)
        return found;
    const RotaryFrame& frame = set.frame();
    return joined(
        found, {{"r1_tool_deg", degrees(angle_between(frame.r1_axis, frame.tool_axis))},
                {"r2_tool_deg", degrees(angle_between(frame.r2_axis, frame.tool_axis))},
                {"asymmetric_cells", asymmetric(set, cells)}});
}

}  // namespace endmill
