// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/offset/detail/offset_grid.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/surface/continuity.h"

namespace endmill {
namespace {

// How a surface continues across a border between patches: with the same first
// derivatives; with the same tangent plane only; with a crease or a gap.
enum class Break { Smooth, Kink, Parted };

// A larger relative difference of first derivatives is more than rounding.
constexpr double kink_share = 1e-9;
// Share of the distance between grid lines. A border of patches within that distance of a
// grid line takes its place.
constexpr double same_line_share = 1e-6;
constexpr int samples_per_side = 17;
// If the sine of the angle between the partials is larger, `is_singular` need not be
// called.
constexpr double plain_sine = 1e-6;

Parameter other(Parameter along)
{
    return along == Parameter::U ? Parameter::V : Parameter::U;
}

// The points and partials on both sides of border `number` across `along`, at parameter
// `t` along it, in row or column `across` of the patches.
std::array<SurfaceTangents, 2> tangents_beside(const Surface& surface, Parameter along,
                                               int number, int across, double t)
{
    const double at = surface.breaks(along)[number];
    const auto tangents = [&](int patch) -> SurfaceTangents {
        const bool is_u = along == Parameter::U;
        const SurfaceJet jet = is_u ? surface.jet_in_patch(patch, across, at, t)
                                    : surface.jet_in_patch(across, patch, t, at);
        return {jet.point, jet.du, jet.dv};
    };
    return {tangents(number - 1), tangents(number)};
}

// Classifies a border at one of its points.
Break break_between(const Surface& surface, Parameter along,
                    const std::array<SurfaceTangents, 2>& beside)
{
    const auto& [one, two] = beside;
    const double gap = (one.point - two.point).norm();
    double angle = 0;
    if (!is_singular(one) && !is_singular(two)) {
        const Vec3 normal = unit_normal(one);
        angle = std::atan2(normal.cross(unit_normal(two)).norm(),
                           normal.dot(unit_normal(two)));
    }
    if (continuity_of(gap, Angle::radians(angle), surface.diagonal()) != Continuity::G1)
        return Break::Parted;
    const Vec3& before = along == Parameter::U ? one.du : one.dv;
    const Vec3& behind = along == Parameter::U ? two.du : two.dv;
    return (before - behind).norm() > kink_share * (before.norm() + behind.norm())
               ? Break::Kink
               : Break::Smooth;
}

// Whether two patches have the same first derivatives across their common border,
// according to their control points. This is cheap, and it is sufficient for polynomial
// patches of equal degree.
bool is_smooth_by_control_points(const Surface& surface, Parameter along, int number,
                                 int across)
{
    const bool is_u = along == Parameter::U;
    const auto patch = [&](int k) -> const BezierPatch& {
        return is_u ? surface.patch(k, across) : surface.patch(across, k);
    };
    const BezierPatch& one = patch(number - 1);
    const BezierPatch& two = patch(number);
    const int degree = one.degree(along);
    const int rows = one.degree(other(along));
    if (one.is_rational() || two.is_rational() || two.degree(other(along)) != rows)
        return false;
    const auto breaks = surface.breaks(along);
    const double before = degree / (breaks[number] - breaks[number - 1]);
    const double behind = two.degree(along) / (breaks[number + 1] - breaks[number]);
    const auto point = [&](const BezierPatch& of, int k, int row) {
        return is_u ? of.control_point(k, row) : of.control_point(row, k);
    };
    for (int row = 0; row <= rows; ++row) {
        const Vec3 end = point(one, degree, row);
        const Vec3 start = point(two, 0, row);
        const Vec3 slope_before = before * (end - point(one, degree - 1, row));
        const Vec3 slope_behind = behind * (point(two, 1, row) - start);
        if (end != start || (slope_before - slope_behind).norm() >
                                kink_share * (slope_before.norm() + slope_behind.norm()))
            return false;
    }
    return true;
}

// The worst class that border `number` has anywhere along it.
Break break_at(const Surface& surface, Parameter along, int number)
{
    Break worst = Break::Smooth;
    const auto breaks = surface.breaks(other(along));
    for (int across = 0; across < surface.patches(other(along)); ++across) {
        if (is_smooth_by_control_points(surface, along, number, across))
            continue;
        for (int k = 0; k < samples_per_side; ++k) {
            const double t = std::lerp(breaks[across], breaks[across + 1],
                                       k / double(samples_per_side - 1));
            worst = std::max(
                worst, break_between(surface, along,
                                     tangents_beside(surface, along, number, across, t)));
        }
    }
    return worst;
}

// The grid lines along one parameter, as one list for each grid. A border of patches with
// a crease or a gap ends a list and begins the next one; both contain it.
std::vector<std::vector<GridLine>> lines_of_grids(const Surface& surface, Parameter along,
                                                  int grid_lines)
{
    const Interval range = surface.range(along);
    const auto line_at = [&](int number) {
        return std::lerp(range.low, range.high, number / double(grid_lines - 1));
    };
    const double same_line = same_line_share * range.length() / (grid_lines - 1);
    const auto breaks = surface.breaks(along);
    std::vector<std::vector<GridLine>> grids(1);
    int line = 0;
    const auto add_lines_below = [&](double end) {
        for (; line < grid_lines; ++line) {
            const double at = line_at(line);
            if (at >= end - same_line)
                break;
            grids.back().push_back({at, surface.patch_number(along, at)});
        }
    };
    const auto skip_lines_at = [&](double at) {
        while (line < grid_lines && line_at(line) <= at + same_line)
            ++line;
    };
    for (int number = 1; number < surface.patches(along); ++number) {
        const Break kind = break_at(surface, along, number);
        if (kind == Break::Smooth)
            continue;
        add_lines_below(breaks[number]);
        skip_lines_at(breaks[number]);
        if (kind == Break::Parted) {
            grids.back().push_back({breaks[number], number - 1});
            grids.emplace_back();
        }
        grids.back().push_back({breaks[number], number});
    }
    add_lines_below(range.high);
    grids.back().push_back({range.high, surface.patches(along) - 1});
    return grids;
}

}  // namespace

std::vector<std::array<std::int32_t, 2>> OffsetGrid::side_places(int number) const
{
    const std::array<std::array<std::int32_t, 2>, 4> corners{
        {{0, 0}, {columns() - 1, 0}, {columns() - 1, rows() - 1}, {0, rows() - 1}}};
    // In a mirrored parametrisation the sides run in the opposite order.
    const int step = side > 0 ? 1 : 3;
    auto [i, j] = corners[(number * step) % 4];
    const auto [last_i, last_j] = corners[((number + 1) * step) % 4];
    std::vector<std::array<std::int32_t, 2>> places{{i, j}};
    while (i != last_i || j != last_j) {
        i += (last_i > i) - (last_i < i);
        j += (last_j > j) - (last_j < j);
        places.push_back({i, j});
    }
    return places;
}

SurfaceTangents tangents_at(const OffsetGrid& grid, const Surface& surface,
                            std::int32_t i, std::int32_t j)
{
    const GridLine& u = grid.u[i];
    const GridLine& v = grid.v[j];
    const auto local = [&](Parameter along, const GridLine& line) {
        const auto breaks = surface.breaks(along);
        return (line.parameter - breaks[line.patch]) /
               (breaks[line.patch + 1] - breaks[line.patch]);
    };
    return surface.patch(u.patch, v.patch)
        .tangents(local(Parameter::U, u), local(Parameter::V, v));
}

Vec3 normal_at(const OffsetGrid& grid, const Surface& surface, std::int32_t i,
               std::int32_t j, const SurfaceTangents& tangents)
{
    const Vec3 across = tangents.du.cross(tangents.dv);
    const double area2 = across.squaredNorm();
    if (area2 >
        plain_sine * plain_sine * tangents.du.squaredNorm() * tangents.dv.squaredNorm())
        return (grid.side / std::sqrt(area2)) * across;
    if (!is_singular(tangents))
        return grid.side * unit_normal(tangents);
    const GridLine& u = grid.u[i];
    const GridLine& v = grid.v[j];
    const auto limit =
        limit_normal(surface.jet_in_patch(u.patch, v.patch, u.parameter, v.parameter),
                     {i + 1 < grid.columns() ? 1 : -1, j + 1 < grid.rows() ? 1 : -1});
    if (!limit)
        throw GeometryError{"the surface has no normal at " +
                            place_text({u.parameter, v.parameter}, tangents.point)};
    return grid.side * *limit;
}

std::vector<OffsetGrid> offset_grids(std::span<const Surface> surfaces,
                                     std::span<const double> sides, int grid_lines)
{
    std::vector<OffsetGrid> grids;
    std::int32_t next = 0;
    for (std::size_t number = 0; number < surfaces.size(); ++number) {
        const auto columns = lines_of_grids(surfaces[number], Parameter::U, grid_lines);
        const auto rows = lines_of_grids(surfaces[number], Parameter::V, grid_lines);
        for (const auto& v : rows)
            for (const auto& u : columns) {
                grids.push_back(
                    {static_cast<std::int32_t>(number), sides[number], next, u, v});
                next += static_cast<std::int32_t>(u.size() * v.size());
            }
    }
    return grids;
}

}  // namespace endmill
