// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/cell_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "endmill/core/tolerance.h"
#include "endmill/deviation/detail/half_space.h"

// Bounds of the thickness on a cell, from rays at its middle or corners.
// paper/notes/deviation-bounds.md derives them; its equation letters are:
// (a) `hidden_gouge`: a circle with the curvature of corner plus part;
// (b) `least_left_by_planes`: a half space that contains the sweep, against the cell's
// tangent plane;
// (s) `most_left_by_slope`: a parabola with the slope at the middle;
// (d), (e) `most_left_by_corners`: over a flat cell the thickness that one sweep leaves
// is convex, so its maximum is at a corner; a convex combination of two sweeps is convex
// too.

namespace endmill {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
// Number of sweeps that are combined in pairs: those that leave the least at the cell's
// middle.
constexpr std::size_t most_paired = 6;
// Corners are moved towards the middle by this share of the way. At a corner where a
// cutter just ends, rounding would decide otherwise.
constexpr double drawn_in = 1e-9;
// A sweep with a larger slope is not expected to make the surface next to the cell's
// middle.
constexpr double steepest_owner = 4;

using CornerRays = std::array<PartRay, 4>;

}  // namespace

// The greatest corner value is a convex, piecewise linear function of the weight; its kinks
// lie where two corners are equal.
double least_of_means(const CornerValues& a, const CornerValues& b, int corners)
{
    double least = std::min(a.most(), b.most());
    for (int i = 0; i < corners; ++i)
        for (int j = i + 1; j < corners; ++j) {
            const auto p = static_cast<std::size_t>(i);
            const auto q = static_cast<std::size_t>(j);
            const double across = (a.at[p] - a.at[q]) - (b.at[p] - b.at[q]);
            const double share = (b.at[q] - b.at[p]) / across;
            if (!(share > 0 && share < 1))
                continue;
            double greatest = -infinite;
            for (int k = 0; k < corners; ++k) {
                const auto c = static_cast<std::size_t>(k);
                greatest = std::max(greatest, share * a.at[c] + (1 - share) * b.at[c]);
            }
            least = std::min(least, greatest);
        }
    return least;
}

std::optional<std::array<PartRay, 4>> corner_rays(const PartCell& cell,
                                                  const PartCharts& charts)
{
    std::array<PartRay, 4> rays;
    const Eigen::Vector2d middle = cell.centre();
    for (std::size_t k = 0; k < static_cast<std::size_t>(cell.corners); ++k) {
        const auto ray =
            charts.ray(cell.chart, cell.at[k] + drawn_in * (middle - cell.at[k]));
        if (!ray)
            return std::nullopt;
        rays[k] = *ray;
    }
    return rays;
}

double least_by(const MeasuredCell& cell, const HalfSpace& half)
{
    // Change of the normal over the cell.
    const double bend = cell.reach * cell.curvature.absolute;
    double spread = 0;  // extent of the cell along the plane's normal, mm
    for (std::size_t k = 0; k < static_cast<std::size_t>(cell.cell.corners); ++k) {
        const Eigen::Vector2d away = cell.cell.at[k] - cell.cell.centre();
        spread = std::max(
            spread, half.normal.dot(away.x() * cell.ray.du + away.y() * cell.ray.dv));
    }
    const double depth =
        half.normal.dot(cell.ray.point) + spread + cell.reach * bend / 2 - half.least;
    if (depth <= touching_depth)
        return infinite;
    const double rate = half.normal.dot(cell.ray.normal) - bend;
    return rate > 0 ? -depth / rate : -infinite;
}

namespace {

// Returns nothing if the sweep leaves `before` or more at a corner.
std::optional<CornerValues> corner_values(const StraightSweep& sweep,
                                          const CornerRays& rays, int corners,
                                          double before)
{
    CornerValues values{{-infinite, -infinite, -infinite, -infinite}};
    for (std::size_t k = 0; k < static_cast<std::size_t>(corners); ++k) {
        const auto cut = cut_ray(sweep, rays[k], before);
        if (!cut)
            return std::nullopt;
        values.at[k] = cut->thickness;
    }
    return values;
}

// Tries three half spaces and takes the best bound. The first is perpendicular to the way
// from the cell's middle to the sweep; it fails where the sweep touches the part near the
// middle, because this way may then lie in the part's tangent plane. The second is seen
// from one cutter radius below the middle. The third is seen from the depth that these
// two leave open, where the sweep ends; it is needed beside an edge of the part.
double least_by_planes(const MeasuredCell& cell, const StraightSweep& sweep)
{
    const Vec3& middle = cell.ray.point;
    const double least = least_by(cell, half_space_beyond(sweep, middle));
    if (least == infinite)
        return least;
    const Vec3 below = middle - sweep.cutter().radius() * cell.ray.normal;
    const double known = std::max(least, least_by(cell, half_space_beyond(sweep, below)));
    if (!std::isfinite(known))
        return known;
    const Vec3 end = middle + known * cell.ray.normal;
    return std::max(known, least_by(cell, half_space_beyond(sweep, end)));
}

}  // namespace

double least_left_by_planes(const MeasuredCell& cell, std::span<const StraightSweep> all,
                            std::span<const std::int32_t> sweeps)
{
    double least = std::min(cell.cut.thickness, 0.0);
    for (const std::int32_t number : sweeps)
        least =
            std::min(least, least_by_planes(cell, all[static_cast<std::size_t>(number)]));
    return least;
}

std::optional<ClearedPart> part_cleared(const MeasuredCell& cell,
                                        const StraightSweep& sweep)
{
    const HalfSpace half = half_space_beyond(sweep, cell.ray.point);
    const PartCell& of = cell.cell;
    const Eigen::Vector2d middle = of.centre();
    const double bend = cell.reach * cell.curvature.absolute;
    const double at_middle =
        half.normal.dot(cell.ray.point) + cell.reach * bend / 2 - half.least;
    const Eigen::Vector2d rise{half.normal.dot(cell.ray.du),
                               half.normal.dot(cell.ray.dv)};
    const auto depth = [&](const Eigen::Vector2d& at) {
        return at_middle + rise.dot(at - middle) - touching_depth;
    };
    std::vector<Eigen::Vector2d> inside;  // corners of the polygon in the half space
    for (int k = 0; k < of.corners; ++k) {
        const Eigen::Vector2d& from = of.at[static_cast<std::size_t>(k)];
        const Eigen::Vector2d& to = of.at[static_cast<std::size_t>((k + 1) % of.corners)];
        const double a = depth(from);
        const double b = depth(to);
        if (a > 0)
            inside.push_back(from);
        if ((a > 0) != (b > 0))
            inside.emplace_back(from + a / (a - b) * (to - from));
    }
    if (inside.empty())
        return std::nullopt;
    ClearedPart part{Eigen::Vector2d::Zero(), 0};
    for (const Eigen::Vector2d& corner : inside)
        part.at += corner / static_cast<double>(inside.size());
    for (const Eigen::Vector2d& corner : inside) {
        const Eigen::Vector2d away = corner - part.at;
        part.reach = std::max(part.reach,
                              (away.x() * cell.ray.du + away.y() * cell.ray.dv).norm());
    }
    return part;
}

std::vector<std::int32_t> sweeps_on_cell(const MeasuredCell& cell,
                                         std::span<const StraightSweep> all,
                                         std::span<const std::int32_t> sweeps)
{
    std::vector<std::int32_t> found;
    for (const std::int32_t number : sweeps)
        if (least_by_planes(cell, all[static_cast<std::size_t>(number)]) < infinite)
            found.push_back(number);
    return found;
}

double most_left_by_slope(const MeasuredCell& cell, const Cutter& cutter)
{
    const double d = cell.reach;
    const double s = cell.cut.slope;
    const bool is_cut = cell.cut.sweep >= 0;
    if (is_cut && cutter.is_flat())
        return infinite;
    const double corner = is_cut ? 1 / cutter.corner_radius() : 0;
    const auto bend_at = [&](double slope) {
        const double stretch = 1 + slope * slope;
        return corner * stretch * std::sqrt(stretch) + cell.curvature.absolute * stretch;
    };
    // The curvature of a circle as a graph grows with its slope, so the slope at the far
    // end of the cell is used.
    const double steepest = s + d * bend_at(s);
    return cell.cut.thickness + d * s + d * d / 2 * bend_at(steepest);
}

double owner_margin(const MeasuredCell& cell)
{
    return cell.reach * 2 * (1 + std::min(cell.cut.slope, steepest_owner));
}

std::vector<std::int32_t> local_sweeps(const MeasuredCell& cell,
                                       std::span<const StraightSweep> all,
                                       std::span<const std::int32_t> sweeps)
{
    std::vector<std::pair<double, std::int32_t>> candidates;
    const double before = cell.cut.thickness + owner_margin(cell);
    for (const std::int32_t sweep : sweeps)
        if (const auto cut =
                cut_ray(all[static_cast<std::size_t>(sweep)], cell.ray, before))
            candidates.emplace_back(cut->thickness, sweep);
    std::ranges::sort(candidates);
    std::vector<std::int32_t> lowest;
    lowest.reserve(candidates.size());
    for (const auto& [thickness, sweep] : candidates)
        lowest.push_back(sweep);
    return lowest;
}

double most_left_by_corners(const MeasuredCell& cell, const PartCharts& charts,
                            std::span<const StraightSweep> all,
                            std::span<const std::int32_t> sweeps)
{
    const auto rays = corner_rays(cell.cell, charts);
    if (!rays)
        return infinite;
    double least = infinite;
    std::vector<CornerValues> values;
    const double before = cell.cut.thickness + owner_margin(cell);
    for (const std::int32_t sweep : sweeps.first(std::min(most_paired, sweeps.size()))) {
        const auto value = corner_values(all[static_cast<std::size_t>(sweep)], *rays,
                                         cell.cell.corners, before);
        if (!value)
            continue;
        least = std::min(least, value->most());
        for (const CornerValues& other : values)
            least = std::min(least, least_of_means(*value, other, cell.cell.corners));
        values.push_back(*value);
    }
    return least + cell.reach * cell.reach * cell.curvature.absolute;
}

}  // namespace endmill
