// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/simulation/mown_rays.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/cutter/sweep_entry.h"

namespace endmill {
namespace {

// Of the cutter's radius: what a ray could still lose is then less than rounding makes of
// it, so it need not be looked at.
constexpr double negligible_share = 1e-13;
// Rays of a tile that go ahead of the others.
constexpr int few_rays = 5;

// The half space normal . x >= least that holds all that a sweep clears.
struct HalfSpace {
    Vec3 normal;   // unit, from a place towards the sweep
    double least;  // mm
};

// Around what a cutter clears whose reference point is `low` or higher, or anywhere
// beyond the plane through it across the way from `place`; the point nearest to the place
// lies `way` from it. None if there is no way to go.
std::optional<HalfSpace> half_space(const Cutter& cutter, const Vec3& place,
                                    const Vec3& nearest)
{
    Vec3 way = nearest - place;
    const double distance = way.head<2>().norm();
    if (distance > 0)
        way.head<2>() *= std::max(0.0, 1 - cutter.flat_radius() / distance);
    way.z() = std::max(way.z(), 0.0);  // the region is open above
    const double gap = way.norm();
    if (!(gap > 0))
        return std::nullopt;
    way /= gap;
    return HalfSpace{way, way.dot(nearest) - cutter.flat_radius() * way.head<2>().norm() -
                              cutter.corner_radius()};
}

// The same for a sweep: square to the way from `place` to its nearest reference point.
std::optional<HalfSpace> half_space_beyond(const StraightSweep& sweep, const Vec3& place)
{
    const Vec3 from = sweep.from() + Vec3{0, 0, sweep.cutter().corner_radius()};
    const Vec3 move = sweep.to() - sweep.from();
    const double length2 = move.squaredNorm();
    const double share =
        length2 > 0 ? std::clamp(move.dot(place - from) / length2, 0.0, 1.0) : 0;
    const Vec3 nearest = from + share * move;
    auto found = half_space(sweep.cutter(), place, nearest);
    if (found) {
        // Square to the way is not square to the move above a flat bottom, nor above an end.
        const double rate = found->normal.dot(move);
        found->least += std::min(-share * rate, (1 - share) * rate);
    }
    return found;
}

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
    if (!entry || !(entry->t >= 0 || clears(sweep, ray.point)))
        return std::nullopt;
    return MownRay{entry->t, tangent_of(entry->normal.dot(ray.normal)), -1};
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

// Whether no ray, `margin` longer than it is, comes within `margin` of the half space
// normal . x >= least: by the slab and the cylinder around the points and the cone around the normals.
bool MownRays::is_out_of_reach(const Vec3& normal, double least, double margin) const
{
    const double along = normal.dot(upright_);
    const double across = (normal - along * upright_).norm();
    const double most = beside_ * across + above_ * std::abs(along) +
                        (longest_ + margin) * std::max(0.0, along + tilt_) + margin;
    return least - normal.dot(centre_) >= most;
}

// Whether a cutter with its reference point there or beyond could shorten a ray.
bool MownRays::may_matter(const SweepTree& tree, const Vec3& nearest, double margin) const
{
    const auto beyond = half_space(tree.sweeps().front().cutter(), centre_, nearest);
    return !beyond || !is_out_of_reach(beyond->normal, beyond->least, margin);
}

// Whether the sweep could shorten a ray whose length is `margin` more than what is left,
// or one as near as that beside it; `short_by` is how far each then lies beyond the
// sweep's half space: below 0 it may.
bool MownRays::may_reach(const StraightSweep& sweep, double margin, Row& short_by) const
{
    const auto beyond = half_space_beyond(sweep, centre_);
    if (!beyond) {
        short_by.fill(-1);
        return true;
    }
    const auto& [w, least] = *beyond;
    if (is_out_of_reach(w, least, margin))
        return false;
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
        centre_, [&](const Vec3& nearest) { return may_matter(tree, nearest, 0); },
        [&](std::size_t number) {
            mow(tree.sweeps()[number], static_cast<std::int32_t>(number));
        });
}

std::vector<std::int32_t> MownRays::near_sweeps(const SweepTree& tree,
                                                double margin) const
{
    std::vector<std::int32_t> near;
    Row short_by;
    tree.visit(
        centre_, [&](const Vec3& nearest) { return may_matter(tree, nearest, margin); },
        [&](std::size_t number) {
            if (may_reach(tree.sweeps()[number], margin, short_by))
                near.push_back(static_cast<std::int32_t>(number));
        });
    std::ranges::sort(near);
    near.erase(std::unique(near.begin(), near.end()), near.end());
    return near;
}

}  // namespace endmill
