// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/simulation/mown_rays.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/cutter/sweep_entry.h"
#include "endmill/simulation/half_space.h"

namespace endmill {
namespace {

// Of the cutter's radius: what a ray could still lose is then less than rounding makes of
// it, so it need not be looked at.
constexpr double negligible_share = 1e-13;
// mm: what ends so near below a ray's point, as a cutter that just touches a wall, ends
// there.
constexpr double touching = 1e-9;
// Rays of a tile that go ahead of the others.
constexpr int few_rays = 5;

double tangent_of(double cosine)
{
    const double c = std::abs(cosine);
    return c > 0 ? std::sqrt(std::max(0.0, (1 - c) * (1 + c))) / c
                 : std::numeric_limits<double>::infinity();
}

}  // namespace

std::optional<MownRay> mown(const StraightSweep& sweep, const PartRay& ray, double before)
{
    const auto entry = sweep_entry(sweep, {ray.point, ray.normal}, before);
    if (!entry)
        return std::nullopt;
    double left = entry->t;
    if (left < 0 && !clears(sweep, ray.point)) {
        if (left < -touching || before <= 0)
            return std::nullopt;
        left = 0;
    }
    return MownRay{left, tangent_of(entry->normal.dot(ray.normal)), -1};
}

MownRays::MownRays(std::span<const PartRay> rays, std::span<const double> lengths)
    : count_{static_cast<int>(rays.size())},
      centre_{Vec3::Zero()}
{
    require(
        !rays.empty() && rays.size() <= most_tile_cells && rays.size() == lengths.size(),
        "MownRays: need 1 to 64 rays and a length for each");
    upright_ = Vec3::Zero();
    for (const PartRay& ray : rays) {
        centre_ += ray.point / double(count_);
        upright_ += ray.normal / double(count_);
    }
    // Any direction serves; the mean of the normals serves best.
    const double size = upright_.norm();
    upright_ = size > 0 ? Vec3{upright_ / size} : Vec3::UnitZ();
    for (std::size_t k = 0; k < rays.size(); ++k) {
        for (int c = 0; c < 3; ++c) {
            point_[static_cast<std::size_t>(c)][k] = rays[k].point[c];
            normal_[static_cast<std::size_t>(c)][k] = rays[k].normal[c];
        }
        const Vec3 away = rays[k].point - centre_;
        const double along = away.dot(upright_);
        above_ = std::max(above_, std::abs(along));
        beside_ = std::max(beside_, (away - along * upright_).norm());
        tilt_ = std::max(tilt_, (rays[k].normal - upright_).norm());
        left_[k] = mown_[k].left = lengths[k];
    }
    longest_ = longest();
}

PartRay MownRays::ray(std::size_t k) const
{
    PartRay ray;
    ray.point = {point_[0][k], point_[1][k], point_[2][k]};
    ray.normal = {normal_[0][k], normal_[1][k], normal_[2][k]};
    return ray;
}

double MownRays::longest() const
{
    return std::max(0.0, *std::max_element(left_.begin(), left_.begin() + count_));
}

// Whether no ray, `length` long, comes within `margin` of the half space: by the slab and
// the cylinder around the points and the cone around the normals.
bool MownRays::is_out_of_reach(const HalfSpace& half, double margin, double length) const
{
    const double along = half.normal.dot(upright_);
    const double across = (half.normal - along * upright_).norm();
    const double most = beside_ * across + above_ * std::abs(along) +
                        length * std::max(0.0, along + tilt_) + margin;
    return half.least - half.normal.dot(centre_) >= most;
}

// Whether a cutter with its reference point there or beyond could shorten a ray.
bool MownRays::may_matter(const SweepTree& tree, const Vec3& nearest, double margin,
                          double length) const
{
    const Cutter& cutter = tree.sweeps().front().cutter();
    return !is_out_of_reach(half_space(cutter, centre_, nearest), margin, length);
}

// Whether the sweep could shorten a ray whose length is `margin` more than what is left,
// or one as near as that beside it; `short_by` is how far each then lies beyond the
// sweep's half space: below 0 it may.
bool MownRays::may_reach(const StraightSweep& sweep, double margin, Row& short_by) const
{
    const HalfSpace half = half_space_beyond(sweep, centre_);
    if (is_out_of_reach(half, margin, longest_ + margin))
        return false;
    const auto& [w, least] = half;
    double nearest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < count_; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const double at =
            w.x() * point_[0][k] + w.y() * point_[1][k] + w.z() * point_[2][k];
        const double rate =
            w.x() * normal_[0][k] + w.y() * normal_[1][k] + w.z() * normal_[2][k];
        short_by[k] = least - margin - at -
                      std::max(0.0, left_[k] + margin) * std::max(0.0, rate) +
                      negligible_share * sweep.cutter().radius();
        nearest = std::min(nearest, short_by[k]);
    }
    return nearest < 0;
}

void MownRays::mow(const StraightSweep& sweep, std::int32_t number)
{
    Row short_by;
    if (!may_reach(sweep, 0, short_by))
        return;
    bool is_shorter = false;
    for (int i = 0; i < count_; ++i) {
        const auto k = static_cast<std::size_t>(i);
        if (short_by[k] >= 0)
            continue;
        const auto found = mown(sweep, ray(k), left_[k]);
        if (!found)
            continue;
        mown_[k] = *found;
        mown_[k].sweep = number;
        left_[k] = found->left;
        is_shorter = true;
    }
    if (is_shorter)
        longest_ = longest();
}

// Its first, middle and last rays.
MownRays MownRays::some() const
{
    std::vector<PartRay> rays;
    std::vector<double> lengths;
    for (int i = 0; i < few_rays; ++i) {
        const auto k = static_cast<std::size_t>(i * (count_ - 1) / (few_rays - 1));
        rays.push_back(ray(k));
        lengths.push_back(left_[k]);
    }
    return {rays, lengths};
}

void MownRays::mow(const SweepTree& tree)
{
    if (count_ > 2 * few_rays) {
        // What is left of a few rays tells which sweeps matter: with them first, hardly
        // any other has to be looked at.
        MownRays few = some();
        few.mow(tree);
        for (int i = 0; i < few_rays; ++i)
            if (const std::int32_t number = few[i].sweep; number >= 0)
                mow(tree.sweeps()[static_cast<std::size_t>(number)], number);
    }
    if (tree.sweeps().empty())
        return;
    tree.visit(
        centre_,
        [&](const Vec3& nearest) { return may_matter(tree, nearest, 0, longest_); },
        [&](std::size_t number) {
            mow(tree.sweeps()[number], static_cast<std::int32_t>(number));
        });
}

std::vector<std::int32_t> MownRays::near_sweeps(const SweepTree& tree,
                                                double margin) const
{
    std::vector<std::int32_t> near;
    if (tree.sweeps().empty())
        return near;
    Row short_by;
    tree.visit(
        centre_,
        [&](const Vec3& nearest) {
            return may_matter(tree, nearest, margin, longest_ + margin);
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
        if (is_out_of_reach(half, reach + sag, 0))
            return false;
        for (int i = 0; i < count_; ++i) {
            const PartRay at = ray(static_cast<std::size_t>(i));
            const double along = half.normal.dot(at.normal);
            const double across = (half.normal - along * at.normal).norm();
            if (half.least - half.normal.dot(at.point) < reach * across + sag)
                return true;
        }
        return false;
    };
    tree.visit(
        centre_,
        [&](const Vec3& nearest) { return may_matter(tree, nearest, reach + sag, 0); },
        [&](std::size_t number) {
            if (may_clear(half_space_beyond(tree.sweeps()[number], centre_)))
                beneath.push_back(static_cast<std::int32_t>(number));
        });
    std::ranges::sort(beneath);
    beneath.erase(std::unique(beneath.begin(), beneath.end()), beneath.end());
    return beneath;
}

}  // namespace endmill
