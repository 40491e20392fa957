// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/surface.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>

#include "endmill/core/error.h"

namespace endmill {
namespace {

// A parameter in the coordinates of its patch, with the derivative: one over the patch's
// width.
struct LocalParameter {
    double value;
    double slope;
};

LocalParameter localize(std::span<const double> breaks, int number, double parameter)
{
    const double slope = 1 / (breaks[number + 1] - breaks[number]);
    return {(parameter - breaks[number]) * slope, slope};
}

bool rises(std::span<const double> breaks)
{
    return std::ranges::all_of(breaks, [](double b) { return std::isfinite(b); }) &&
           std::ranges::adjacent_find(breaks, std::ranges::greater_equal{}) ==
               breaks.end();
}

// Diagonal of the bounding box of all control points.
double net_diagonal(std::span<const BezierPatch> patches)
{
    Eigen::AlignedBox3d box;
    for (const BezierPatch& patch : patches)
        for (int j = 0; j <= patch.degree(Parameter::V); ++j)
            for (int i = 0; i <= patch.degree(Parameter::U); ++i)
                box.extend(patch.control_point(i, j));
    return box.diagonal().norm();
}

std::vector<double> copied(std::span<const double> values)
{
    return {values.begin(), values.end()};
}

// The tool side after the parametrisation has been mirrored.
ToolSide mirrored(ToolSide side)
{
    if (side == ToolSide::Up)
        return side;
    return side == ToolSide::DuCrossDv ? ToolSide::DvCrossDu : ToolSide::DuCrossDv;
}

std::vector<double> whole_numbers_to(int last)
{
    std::vector<double> numbers(static_cast<std::size_t>(last) + 1);
    std::iota(numbers.begin(), numbers.end(), 0.0);
    return numbers;
}

}  // namespace

Surface::Surface(std::vector<double> breaks_u, std::vector<double> breaks_v,
                 std::vector<BezierPatch> patches, ToolSide tool_side)
    : breaks_u_{std::move(breaks_u)},
      breaks_v_{std::move(breaks_v)},
      patches_{std::move(patches)},
      tool_side_{tool_side},
      diagonal_{net_diagonal(patches_)}
{
    require(breaks_u_.size() >= 2 && breaks_v_.size() >= 2,
            "Surface: need at least one patch");
    require((breaks_u_.size() - 1) * (breaks_v_.size() - 1) == patches_.size(),
            "Surface: the number of patches does not match the breaks");
    require(rises(breaks_u_) && rises(breaks_v_),
            "Surface: the breaks are not finite and rising");
}

int Surface::patches(Parameter along) const
{
    return static_cast<int>(breaks(along).size()) - 1;
}

Interval Surface::range(Parameter along) const
{
    return {breaks(along).front(), breaks(along).back()};
}

int Surface::patch_number(Parameter along, double parameter) const
{
    const auto inner = breaks(along).subspan(1, breaks(along).size() - 2);
    return static_cast<int>(std::ranges::upper_bound(inner, parameter) - inner.begin());
}

double Surface::patch_width(Parameter along, double parameter) const
{
    const int number = patch_number(along, parameter);
    return breaks(along)[number + 1] - breaks(along)[number];
}

SurfaceTangents Surface::tangents(double u, double v) const
{
    const int i = patch_number(Parameter::U, u);
    const int j = patch_number(Parameter::V, v);
    const LocalParameter s = localize(breaks_u_, i, u);
    const LocalParameter t = localize(breaks_v_, j, v);
    SurfaceTangents tangents = patch(i, j).tangents(s.value, t.value);
    tangents.du *= s.slope;
    tangents.dv *= t.slope;
    return tangents;
}

SurfaceJet Surface::jet(double u, double v) const
{
    return jet_in_patch(patch_number(Parameter::U, u), patch_number(Parameter::V, v), u,
                        v);
}

SurfaceJet Surface::jet_in_patch(int i, int j, double u, double v) const
{
    const LocalParameter s = localize(breaks_u_, i, u);
    const LocalParameter t = localize(breaks_v_, j, v);
    SurfaceJet jet = patch(i, j).jet(s.value, t.value);
    jet.du *= s.slope;
    jet.dv *= t.slope;
    jet.duu *= s.slope * s.slope;
    jet.duv *= s.slope * t.slope;
    jet.dvv *= t.slope * t.slope;
    return jet;
}

Surface composite_bezier(int patches_u, int patches_v, std::span<const Vec3> net,
                         ToolSide tool_side)
{
    require(patches_u >= 1 && patches_v >= 1, "composite_bezier: need a patch each way");
    const std::size_t columns = 3 * static_cast<std::size_t>(patches_u) + 1;
    const std::size_t rows = 3 * static_cast<std::size_t>(patches_v) + 1;
    require(net.size() == columns * rows,
            "composite_bezier: the net does not have (3 patches_u + 1)(3 patches_v + 1) "
            "points");
    std::vector<BezierPatch> patches;
    patches.reserve(static_cast<std::size_t>(patches_u) * patches_v);
    for (int j = 0; j < patches_v; ++j)
        for (int i = 0; i < patches_u; ++i) {
            std::array<Vec3, 16> points;
            for (int row = 0; row < 4; ++row)
                std::ranges::copy(net.subspan((3 * j + row) * columns + 3 * i, 4),
                                  points.begin() + 4 * row);
            patches.emplace_back(points);
        }
    return Surface{whole_numbers_to(patches_u), whole_numbers_to(patches_v),
                   std::move(patches), tool_side};
}

Surface transposed(const Surface& surface)
{
    std::vector<BezierPatch> patches;
    for (int i = 0; i < surface.patches(Parameter::U); ++i)
        for (int j = 0; j < surface.patches(Parameter::V); ++j)
            patches.push_back(transposed(surface.patch(i, j)));
    return Surface{copied(surface.breaks(Parameter::V)),
                   copied(surface.breaks(Parameter::U)), std::move(patches),
                   mirrored(surface.tool_side())};
}

Surface reversed_in_u(const Surface& surface)
{
    std::vector<double> breaks_u = copied(surface.breaks(Parameter::U));
    const double sum = breaks_u.front() + breaks_u.back();
    std::ranges::reverse(breaks_u);
    for (double& u : breaks_u)
        u = sum - u;
    std::vector<BezierPatch> patches;
    for (int j = 0; j < surface.patches(Parameter::V); ++j)
        for (int i = surface.patches(Parameter::U); i-- > 0;)
            patches.push_back(reversed_in_u(surface.patch(i, j)));
    return Surface{std::move(breaks_u), copied(surface.breaks(Parameter::V)),
                   std::move(patches), mirrored(surface.tool_side())};
}

}  // namespace endmill
