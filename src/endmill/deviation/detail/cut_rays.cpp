// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/cut_rays.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "endmill/core/error.h"
#include "endmill/deviation/detail/ball_rows.h"
#include "endmill/deviation/detail/half_space.h"
#include "endmill/deviation/detail/sweep_rows.h"

// A tile has up to 64 rays, and a path may have a million moves. The rays are cut in
// three steps.
// 1. A few rays per tile are cut by the whole tree. The sweeps that made their ends are
//    likely to make those of the neighbours.
// 2. All rays are cut by these sweeps. They are short now.
// 3. The remaining sweeps are tested against the short rays: a half space that contains
//    the sweep, against a cylinder and a cone that contain the rays (`RayBounds`). Hardly
//    any passes.
// For several tiles together, step 3 makes one list of candidates for all of them
// (`SweepRows`).

namespace endmill {
namespace {

// Share of the cutter's radius by which a ray may still be shortened without effect,
// because it is less than the rounding error.
constexpr double negligible_share = 1e-13;
// Rays of a tile that are cut first.
constexpr int few_rays = 5;
// Tiles with a common list of sweeps. Tiles arise by halving a patch, so four consecutive
// ones mostly form a square.
constexpr std::size_t tiles_beside = 4;

bool holds(std::span<const std::int32_t> numbers, std::int32_t number)
{
    return std::ranges::find(numbers, number) != numbers.end();
}

}  // namespace

CutRays::CutRays(std::span<const PartRay> rays, std::span<const double> lengths)
    : bounds_{Vec3::Zero(), Vec3::Zero()}
{
    require(
        !rays.empty() && rays.size() <= most_tile_cells && rays.size() == lengths.size(),
        "CutRays: need 1 to 64 rays and a length for each");
    rows_.count = static_cast<int>(rays.size());
    for (const PartRay& ray : rays) {
        bounds_.centre += ray.point;
        bounds_.upright += ray.normal;
    }
    bounds_.centre /= rows_.count;
    // Any axis is valid; the mean of the normals gives the tightest bounds.
    bounds_.upright = unit_or_up(bounds_.upright);
    for (std::size_t k = 0; k < most_tile_cells; ++k) {
        const PartRay& ray = rays[std::min(k, rays.size() - 1)];
        for (int c = 0; c < 3; ++c) {
            rows_.point[static_cast<std::size_t>(c)][k] = ray.point[c];
            rows_.normal[static_cast<std::size_t>(c)][k] = ray.normal[c];
        }
        rows_.left[k] =
            k < rays.size() ? lengths[k] : -std::numeric_limits<double>::infinity();
        rows_.cosine[k] = 1;
        rows_.sweep[k] = -1;
    }
    double beside2 = 0;
    double tilt2 = 0;
    for (const PartRay& ray : rays) {
        const Vec3 away = ray.point - bounds_.centre;
        const double along = away.dot(bounds_.upright);
        bounds_.above = std::max(bounds_.above, std::abs(along));
        beside2 = std::max(beside2, (away - along * bounds_.upright).squaredNorm());
        tilt2 = std::max(tilt2, (ray.normal - bounds_.upright).squaredNorm());
    }
    bounds_.beside = std::sqrt(beside2);
    bounds_.tilt = std::sqrt(tilt2);
    bounds_.longest = longest_left(rows_);
}

CutRay CutRays::operator[](int k) const
{
    const auto i = static_cast<std::size_t>(k);
    return {rows_.left[i], slope_of_cosine(rows_.cosine[i]),
            static_cast<std::int32_t>(rows_.sweep[i])};
}

PartRay CutRays::ray(std::size_t k) const
{
    PartRay ray;
    ray.point = {rows_.point[0][k], rows_.point[1][k], rows_.point[2][k]};
    ray.normal = {rows_.normal[0][k], rows_.normal[1][k], rows_.normal[2][k]};
    return ray;
}

// Whether a cutter whose reference points lie in a box could shorten a ray.
// \param nearest the point of the box that is nearest to the centre of the bounds.
bool CutRays::may_matter(const Cutter& cutter, const Vec3& nearest, double margin,
                         double length) const
{
    return !bounds_.is_out_of_reach(half_space(cutter, bounds_.centre, nearest), margin,
                                    length);
}

// Whether a sweep in this half space could shorten a ray that is `margin` longer than it
// is now, or a ray that close beside it. `short_by` receives the distance of each ray from
// the half space; below 0 the sweep may reach the ray.
bool CutRays::may_reach(const HalfSpace& half, const Cutter& cutter, double margin,
                        RayRows::Row& short_by) const
{
    if (bounds_.is_out_of_reach(half, margin, bounds_.longest + margin))
        return false;
    const double spare = negligible_share * cutter.radius();
    return shortfalls(rows_, half, margin, spare, short_by) < 0;
}

void CutRays::cut(const StraightSweep& sweep, std::int32_t number)
{
    cut(sweep, number, half_space_beyond(sweep, bounds_.centre));
}

// \param half contains what the sweep clears.
void CutRays::cut(const StraightSweep& sweep, std::int32_t number, const HalfSpace& half)
{
    RayRows::Row short_by;
    if (!may_reach(half, sweep.cutter(), 0, short_by))
        return;
    if (sweep.cutter().is_ball())
        shorten_by_ball(rows_, sweep, number, short_by);
    else
        shorten_each(sweep, number, short_by);
    bounds_.longest = longest_left(rows_);
}

void CutRays::shorten_each(const StraightSweep& sweep, std::int32_t number,
                           const RayRows::Row& short_by)
{
    for (int i = 0; i < rows_.count; ++i) {
        const auto k = static_cast<std::size_t>(i);
        if (short_by[k] >= 0)
            continue;
        const auto found = cut_ray(sweep, ray(k), rows_.left[k]);
        if (!found)
            continue;
        rows_.left[k] = found->thickness;
        rows_.cosine[k] = 1 / std::hypot(1.0, found->slope);
        rows_.sweep[k] = number;
    }
}

// Returns a few rays: the first, the last and others evenly between.
CutRays CutRays::some() const
{
    std::vector<PartRay> rays;
    std::vector<double> lengths;
    for (int i = 0; i < few_rays; ++i) {
        const auto k = static_cast<std::size_t>(i * (rows_.count - 1) / (few_rays - 1));
        rays.push_back(ray(k));
        lengths.push_back(rows_.left[k]);
    }
    return {rays, lengths};
}

// Returns the number of the ray whose point is nearest to the place.
std::size_t CutRays::nearest_ray(const Vec3& place) const
{
    std::size_t nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < static_cast<std::size_t>(rows_.count); ++k)
        if (const double away = (ray(k).point - place).squaredNorm(); away < least) {
            nearest = k;
            least = away;
        }
    return nearest;
}

// Returns the middle rays of a few tiles: of the first, of the last and of others evenly
// between.
CutRays CutRays::middles(std::span<CutRays* const> tiles)
{
    std::vector<PartRay> rays;
    std::vector<double> lengths;
    for (std::size_t i = 0; i < few_rays; ++i) {
        const CutRays& tile = *tiles[i * (tiles.size() - 1) / (few_rays - 1)];
        const std::size_t k = tile.nearest_ray(tile.bounds_.centre);
        rays.push_back(tile.ray(k));
        lengths.push_back(tile.rows_.left[k]);
    }
    return {rays, lengths};
}

// Returns the numbers of the sweeps that made the rays, each once.
std::vector<std::int32_t> CutRays::makers() const
{
    std::vector<std::int32_t> numbers;
    for (int i = 0; i < rows_.count; ++i)
        if (const std::int32_t number = (*this)[i].sweep;
            number >= 0 && !holds(numbers, number))
            numbers.push_back(number);
    return numbers;
}

void CutRays::cut_by(const SweepTree& tree, std::span<const std::int32_t> numbers)
{
    for (const std::int32_t number : numbers)
        cut(tree.sweeps()[static_cast<std::size_t>(number)], number);
}

void CutRays::cut(const SweepTree& tree)
{
    if (tree.sweeps().empty())
        return;
    // A second cut by the same sweep changes nothing, so these sweeps need not be cut
    // again.
    std::vector<std::int32_t> done;
    if (rows_.count > 2 * few_rays) {
        // The sweeps that made the ends of a few rays cut all rays first.
        CutRays few = some();
        few.cut(tree);
        done = few.makers();
        cut_by(tree, done);
    }
    tree.visit(
        bounds_.centre,
        [&](const Vec3& nearest, const Cutter& cutter) {
            return may_matter(cutter, nearest, 0, bounds_.longest);
        },
        [&](std::size_t sweep) {
            if (const auto number = static_cast<std::int32_t>(sweep);
                !holds(done, number))
                cut(tree.sweeps()[sweep], number);
        });
}

void CutRays::cut_together(std::span<CutRays* const> tiles, const SweepTree& tree)
{
    if (tiles.empty() || tree.sweeps().empty())
        return;
    CutRays few = middles(tiles);
    few.cut(tree);
    std::vector<RayBounds> bounds;
    for (CutRays* tile : tiles) {
        const CutRay beside =
            few[static_cast<int>(few.nearest_ray(tile->bounds_.centre))];
        if (beside.sweep >= 0)
            tile->cut(tree.sweeps()[static_cast<std::size_t>(beside.sweep)],
                      beside.sweep);
        bounds.push_back(tile->bounds_);
    }
    // The rays are short now, so the list of sweeps that still matter is short.
    const SweepRows sweeps{tree, common_bounds(bounds)};
    for (std::size_t first = 0; first < tiles.size(); first += tiles_beside) {
        const std::size_t count = std::min(tiles_beside, tiles.size() - first);
        const SweepRows few_sweeps =
            sweeps.reduced(common_bounds(std::span{bounds}.subspan(first, count)));
        for (CutRays* tile : tiles.subspan(first, count))
            for (const NearSweep& near : few_sweeps.near(tile->bounds_))
                tile->cut(tree.sweeps()[static_cast<std::size_t>(near.number)],
                          near.number, near.half);
    }
}

std::vector<std::int32_t> CutRays::near_sweeps(const SweepTree& tree, double margin) const
{
    std::vector<std::int32_t> near;
    if (tree.sweeps().empty())
        return near;
    RayRows::Row short_by;
    tree.visit(
        bounds_.centre,
        [&](const Vec3& nearest, const Cutter& cutter) {
            return may_matter(cutter, nearest, margin, bounds_.longest + margin);
        },
        [&](std::size_t number) {
            const StraightSweep& sweep = tree.sweeps()[number];
            if (may_reach(half_space_beyond(sweep, bounds_.centre), sweep.cutter(),
                          margin, short_by))
                near.push_back(static_cast<std::int32_t>(number));
        });
    std::ranges::sort(near);
    near.erase(std::unique(near.begin(), near.end()), near.end());
    return near;
}

std::vector<std::int32_t> CutRays::gouging_sweeps(const SweepTree& tree, double reach,
                                                  double sag) const
{
    std::vector<std::int32_t> gouging;
    if (tree.sweeps().empty())
        return gouging;
    const auto may_clear = [&](const HalfSpace& half) {
        if (bounds_.is_out_of_reach(half, reach + sag, 0))
            return false;
        for (int i = 0; i < rows_.count; ++i) {
            const PartRay at = ray(static_cast<std::size_t>(i));
            const double along = half.normal.dot(at.normal);
            const double across = (half.normal - along * at.normal).norm();
            if (half.least - half.normal.dot(at.point) < reach * across + sag)
                return true;
        }
        return false;
    };
    tree.visit(
        bounds_.centre,
        [&](const Vec3& nearest, const Cutter& cutter) {
            return may_matter(cutter, nearest, reach + sag, 0);
        },
        [&](std::size_t number) {
            if (may_clear(half_space_beyond(tree.sweeps()[number], bounds_.centre)))
                gouging.push_back(static_cast<std::int32_t>(number));
        });
    std::ranges::sort(gouging);
    gouging.erase(std::unique(gouging.begin(), gouging.end()), gouging.end());
    return gouging;
}

}  // namespace endmill
