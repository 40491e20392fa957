// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/cut_rays.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "endmill/core/error.h"
#include "endmill/deviation/detail/ball_rows.h"
#include "endmill/deviation/detail/half_space.h"
#include "endmill/deviation/detail/sweep_rows.h"

namespace endmill {
namespace {

// Of the cutter's radius: what a ray could still lose is then less than rounding makes of
// it, so it need not be looked at.
constexpr double negligible_share = 1e-13;
// Rays of a tile that go ahead of the others.
constexpr int few_rays = 5;

bool holds(std::span<const std::int32_t> numbers, std::int32_t number)
{
    return std::ranges::find(numbers, number) != numbers.end();
}

}  // namespace

MownRays::MownRays(std::span<const PartRay> rays, std::span<const double> lengths)
    : bundle_{Vec3::Zero(), Vec3::Zero()}
{
    require(
        !rays.empty() && rays.size() <= most_tile_cells && rays.size() == lengths.size(),
        "MownRays: need 1 to 64 rays and a length for each");
    rows_.count = static_cast<int>(rays.size());
    for (const PartRay& ray : rays) {
        bundle_.centre += ray.point;
        bundle_.upright += ray.normal;
    }
    bundle_.centre /= rows_.count;
    // Any direction serves; the mean of the normals serves best.
    bundle_.upright = unit_or_up(bundle_.upright);
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
        const Vec3 away = ray.point - bundle_.centre;
        const double along = away.dot(bundle_.upright);
        bundle_.above = std::max(bundle_.above, std::abs(along));
        beside2 = std::max(beside2, (away - along * bundle_.upright).squaredNorm());
        tilt2 = std::max(tilt2, (ray.normal - bundle_.upright).squaredNorm());
    }
    bundle_.beside = std::sqrt(beside2);
    bundle_.tilt = std::sqrt(tilt2);
    bundle_.longest = longest_left(rows_);
}

MownRay MownRays::operator[](int k) const
{
    const auto i = static_cast<std::size_t>(k);
    return {rows_.left[i], slope_of_cosine(rows_.cosine[i]),
            static_cast<std::int32_t>(rows_.sweep[i])};
}

PartRay MownRays::ray(std::size_t k) const
{
    PartRay ray;
    ray.point = {rows_.point[0][k], rows_.point[1][k], rows_.point[2][k]};
    ray.normal = {rows_.normal[0][k], rows_.normal[1][k], rows_.normal[2][k]};
    return ray;
}

// Whether a cutter with its reference point there or beyond could shorten a ray.
bool MownRays::may_matter(const Cutter& cutter, const Vec3& nearest, double margin,
                          double length) const
{
    return !bundle_.is_out_of_reach(half_space(cutter, bundle_.centre, nearest), margin,
                                    length);
}

// Whether the sweep could shorten a ray whose length is `margin` more than what is left,
// or one as near as that beside it; `short_by` is how far each then lies beyond the
// sweep's half space: below 0 it may.
bool MownRays::may_reach(const StraightSweep& sweep, double margin,
                         RayRows::Row& short_by) const
{
    const HalfSpace half = half_space_beyond(sweep, bundle_.centre);
    if (bundle_.is_out_of_reach(half, margin, bundle_.longest + margin))
        return false;
    const double spare = negligible_share * sweep.cutter().radius();
    return shortfalls(rows_, half, margin, spare, short_by) < 0;
}

void MownRays::mow(const StraightSweep& sweep, std::int32_t number)
{
    RayRows::Row short_by;
    if (!may_reach(sweep, 0, short_by))
        return;
    if (sweep.cutter().is_ball())
        shorten_by_ball(rows_, sweep, number, short_by);
    else
        shorten_each(sweep, number, short_by);
    bundle_.longest = longest_left(rows_);
}

void MownRays::shorten_each(const StraightSweep& sweep, std::int32_t number,
                            const RayRows::Row& short_by)
{
    for (int i = 0; i < rows_.count; ++i) {
        const auto k = static_cast<std::size_t>(i);
        if (short_by[k] >= 0)
            continue;
        const auto found = mown(sweep, ray(k), rows_.left[k]);
        if (!found)
            continue;
        rows_.left[k] = found->left;
        rows_.cosine[k] = 1 / std::hypot(1.0, found->slope);
        rows_.sweep[k] = number;
    }
}

// Some of the rays of each, first, middle and last ones.
MownRays MownRays::some(std::span<MownRays* const> tiles, int of_each)
{
    std::vector<PartRay> rays;
    std::vector<double> lengths;
    for (const MownRays* tile : tiles)
        for (int i = 0; i < of_each; ++i) {
            const auto k =
                static_cast<std::size_t>(i * (tile->rows_.count - 1) / (of_each - 1));
            rays.push_back(tile->ray(k));
            lengths.push_back(tile->rows_.left[k]);
        }
    return {rays, lengths};
}

// Numbers of the sweeps that made `count` of the rays, each once.
std::vector<std::int32_t> MownRays::makers(int first, int count) const
{
    std::vector<std::int32_t> numbers;
    for (int i = first; i < first + count; ++i)
        if (const std::int32_t number = (*this)[i].sweep;
            number >= 0 && !holds(numbers, number))
            numbers.push_back(number);
    return numbers;
}

void MownRays::mow_by(const SweepTree& tree, std::span<const std::int32_t> numbers)
{
    for (const std::int32_t number : numbers)
        mow(tree.sweeps()[static_cast<std::size_t>(number)], number);
}

void MownRays::mow(const SweepTree& tree)
{
    if (tree.sweeps().empty())
        return;
    // A sweep leaves nothing to itself, so that it need not come twice.
    std::vector<std::int32_t> done;
    if (rows_.count > 2 * few_rays) {
        // What is left of a few rays tells which sweeps matter: with them first, hardly
        // any other has to be looked at.
        MownRays* const own[] = {this};
        MownRays few = some(own, few_rays);
        few.mow(tree);
        done = few.makers(0, few_rays);
        mow_by(tree, done);
    }
    tree.visit(
        bundle_.centre,
        [&](const Vec3& nearest, const Cutter& cutter) {
            return may_matter(cutter, nearest, 0, bundle_.longest);
        },
        [&](std::size_t sweep) {
            if (const auto number = static_cast<std::int32_t>(sweep);
                !holds(done, number))
                mow(tree.sweeps()[sweep], number);
        });
}

void MownRays::mow_together(std::span<MownRays* const> tiles, const SweepTree& tree)
{
    if (tiles.empty() || tree.sweeps().empty())
        return;
    const int of_each = most_tile_cells / static_cast<int>(tiles.size());
    require(of_each > 1, "MownRays: need 32 tiles at most");
    const int few = std::min(of_each, few_rays);
    MownRays first = some(tiles, few);
    first.mow(tree);
    std::vector<RayBundle> bundles;
    std::vector<std::vector<std::int32_t>> done;
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        done.push_back(first.makers(static_cast<int>(i) * few, few));
        tiles[i]->mow_by(tree, done.back());
        bundles.push_back(tiles[i]->bundle_);
    }
    // Little is left of all now, so that all that still matters is a short list.
    const SweepRows sweeps{tree, common_bundle(bundles)};
    for (std::size_t i = 0; i < tiles.size(); ++i)
        for (const std::int32_t number : sweeps.near(tiles[i]->bundle_))
            if (!holds(done[i], number))
                tiles[i]->mow(tree.sweeps()[static_cast<std::size_t>(number)], number);
}

std::vector<std::int32_t> MownRays::near_sweeps(const SweepTree& tree,
                                                double margin) const
{
    std::vector<std::int32_t> near;
    if (tree.sweeps().empty())
        return near;
    RayRows::Row short_by;
    tree.visit(
        bundle_.centre,
        [&](const Vec3& nearest, const Cutter& cutter) {
            return may_matter(cutter, nearest, margin, bundle_.longest + margin);
        },
        [&](std::size_t number) {
            if (may_reach(tree.sweeps()[number], margin, short_by))
                near.push_back(static_cast<std::int32_t>(number));
        });
    std::ranges::sort(near);
    near.erase(std::unique(near.begin(), near.end()), near.end());
    return near;
}

std::vector<std::int32_t> MownRays::sweeps_beneath(const SweepTree& tree, double reach,
                                                   double sag) const
{
    std::vector<std::int32_t> beneath;
    if (tree.sweeps().empty())
        return beneath;
    const auto may_clear = [&](const HalfSpace& half) {
        if (bundle_.is_out_of_reach(half, reach + sag, 0))
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
        bundle_.centre,
        [&](const Vec3& nearest, const Cutter& cutter) {
            return may_matter(cutter, nearest, reach + sag, 0);
        },
        [&](std::size_t number) {
            if (may_clear(half_space_beyond(tree.sweeps()[number], bundle_.centre)))
                beneath.push_back(static_cast<std::int32_t>(number));
        });
    std::ranges::sort(beneath);
    beneath.erase(std::unique(beneath.begin(), beneath.end()), beneath.end());
    return beneath;
}

}  // namespace endmill
