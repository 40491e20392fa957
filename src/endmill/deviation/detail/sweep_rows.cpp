// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/sweep_rows.h"

#include <algorithm>
#include <limits>

#include "endmill/core/detail/widest_registers.h"
#include "endmill/stock/detail/tile_heights.h"

namespace endmill {
namespace {

using SweepBlock = SweepRows::Block;
using Column = SweepBlock::Column;

// The half spaces of a block of sweeps. All but `size` are multiplied by `size`.
struct Gaps {
    Column gap;    // distance from the reach of the rays; below 0 a sweep may reach them
    Column x;      // normal
    Column y;      // normal
    Column z;      // normal
    Column size;   // length of the direction to the sweep, mm
    Column least;  // as in HalfSpace, from the centre of the rays
    // Below 0 if the normal is not perpendicular to the move. Another normal may then be
    // better.
    Column lost;
};

double reciprocal(double value)
{
    // For shorter moves the position on the move does not matter, and the reciprocal
    // would overflow.
    return value > 1 / std::numeric_limits<double>::max() ? 1 / value : 0;
}

// Computes the half spaces of `half_space`, and their distances from the rays by the bounds
// of `RayBounds::is_out_of_reach`, without a division. A distance of 0 or more is certain.
ENDMILL_WIDEST_REGISTERS
void measure_gaps(const RayBounds& rays, const SweepBlock& sweeps, std::size_t count,
                  Gaps& gaps)
{
    const double cx = rays.centre.x();
    const double cy = rays.centre.y();
    const double cz = rays.centre.z();
    const double ux = rays.upright.x();
    const double uy = rays.upright.y();
    const double uz = rays.upright.z();
    const auto [tilt, rays_beside, rays_above, longest] =
        std::array{rays.tilt, rays.beside, rays.above, rays.longest};
    for (std::size_t k = 0; k < count; ++k) {
        const double px = cx - sweeps.x[k];
        const double py = cy - sweeps.y[k];
        const double pz = cz - sweeps.z[k];
        const double dx = sweeps.dx[k];
        const double dy = sweeps.dy[k];
        const double dz = sweeps.dz[k];
        const double flat = sweeps.flat_radius[k];
        // The reference point nearest to the centre. If the centre lies above it, the
        // nearest point in plan is used, because the volume is open above.
        const double level = px * dx + py * dy;
        const double at = (level + pz * dz) * sweeps.per_squared[k];
        const double positive = select(at > 0, at, 0);
        const double nearest = select(positive < 1, positive, 1);
        const double at_level = level * sweeps.per_level[k];
        const double positive_level = select(at_level > 0, at_level, 0);
        const double nearest_level = select(positive_level < 1, positive_level, 1);
        const double share = select(pz > nearest * dz, nearest_level, nearest);
        double wx = share * dx - px;
        double wy = share * dy - py;
        const double up = share * dz - pz;
        const double wz = select(up > 0, up, 0);
        const double across = std::sqrt(wx * wx + wy * wy);
        const double beside = select(across > flat, across - flat, 0);
        const double kept = select(across > flat, beside / across, 0);
        wx *= kept;
        wy *= kept;
        const double size = std::sqrt(beside * beside + wz * wz);
        const double turn = wx * dx + wy * dy + wz * dz;
        const double least = -(wx * px + wy * py + wz * pz) + select(turn < 0, turn, 0) -
                             flat * beside - sweeps.corner_radius[k] * size;
        const double along = wx * ux + wy * uy + wz * uz;
        const double ax = wx - along * ux;
        const double ay = wy - along * uy;
        const double az = wz - along * uz;
        const double rate = along + tilt * size;
        const double most = rays_beside * std::sqrt(ax * ax + ay * ay + az * az) +
                            rays_above * std::abs(along) +
                            longest * select(rate > 0, rate, 0);
        gaps.gap[k] = select(size > 0, least - most, -1);
        gaps.x[k] = wx;
        gaps.y[k] = wy;
        gaps.z[k] = wz;
        gaps.size[k] = size;
        gaps.least[k] = least;
        gaps.lost[k] = turn;
    }
}

// Calls `visit(place in the block)` for each sweep of the block that may clear a point of
// the rays, after its half space is computed.
template <typename Visit>
void visit_near_of(const RayBounds& rays, const SweepBlock& block, std::size_t count,
                   Gaps& gaps, const Visit& visit)
{
    measure_gaps(rays, block, count, gaps);
    for (std::size_t k = 0; k < count; ++k)
        if (!(gaps.gap[k] >= 0))
            visit(k);
}

}  // namespace

void SweepRows::Block::set(std::size_t k, std::int32_t its_number,
                           const StraightSweep& sweep)
{
    const Vec3 move = sweep.to() - sweep.from();
    const double corner = sweep.cutter().corner_radius();
    number[k] = its_number;
    x[k] = sweep.from().x();
    y[k] = sweep.from().y();
    z[k] = sweep.from().z() + corner;
    dx[k] = move.x();
    dy[k] = move.y();
    dz[k] = move.z();
    per_squared[k] = reciprocal(move.squaredNorm());
    per_level[k] = reciprocal(move.head<2>().squaredNorm());
    flat_radius[k] = sweep.cutter().flat_radius();
    corner_radius[k] = corner;
}

void SweepRows::Block::copy(std::size_t k, const Block& other, std::size_t from)
{
    number[k] = other.number[from];
    x[k] = other.x[from];
    y[k] = other.y[from];
    z[k] = other.z[from];
    dx[k] = other.dx[from];
    dy[k] = other.dy[from];
    dz[k] = other.dz[from];
    per_squared[k] = other.per_squared[from];
    per_level[k] = other.per_level[from];
    flat_radius[k] = other.flat_radius[from];
    corner_radius[k] = other.corner_radius[from];
}

// Calls `visit(block, place in it, gaps)` for each sweep that may clear a point of the rays.
template <typename Visit>
void SweepRows::visit_near(const RayBounds& rays, const Visit& visit) const
{
    Gaps gaps;
    for (std::size_t first = 0; first < count_; first += block_size) {
        const Block& block = blocks_[first / block_size];
        visit_near_of(rays, block, std::min(block_size, count_ - first), gaps,
                      [&](std::size_t k) { visit(block, k, gaps); });
    }
}

// Appends one sweep.
void SweepRows::add(const Block& block, std::size_t k)
{
    if (count_ == blocks_.size() * block_size)
        blocks_.emplace_back();
    blocks_.back().copy(count_ % block_size, block, k);
    ++count_;
}

// Appends the sweeps of a block that may clear a point of the rays.
void SweepRows::add_near(const RayBounds& rays, const Block& block, std::size_t count)
{
    Gaps gaps;
    visit_near_of(rays, block, count, gaps, [&](std::size_t k) { add(block, k); });
}

// The sweeps of the tree are tested block by block, because all of them would take much
// memory, most of it for sweeps that are not near.
SweepRows::SweepRows(const SweepTree& tree, const RayBounds& rays)
    : SweepRows{tree.sweeps()}
{
    Block block{};
    std::size_t count = 0;
    tree.visit(
        rays.centre,
        [&](const Vec3& nearest, const Cutter& cutter) {
            return !rays.is_out_of_reach(half_space(cutter, rays.centre, nearest), 0,
                                         rays.longest);
        },
        [&](std::size_t number) {
            block.set(count++, static_cast<std::int32_t>(number), sweeps_[number]);
            if (count == block_size) {
                add_near(rays, block, count);
                count = 0;
            }
        });
    add_near(rays, block, count);
}

SweepRows SweepRows::reduced(const RayBounds& rays) const
{
    SweepRows some{sweeps_};
    visit_near(rays, [&](const Block& block, std::size_t k, const Gaps&) {
        some.add(block, k);
    });
    return some;
}

std::vector<NearSweep> SweepRows::near(const RayBounds& rays) const
{
    std::vector<NearSweep> found;
    found.reserve(count_);
    visit_near(rays, [&](const Block& block, std::size_t k, const Gaps& gaps) {
        const std::int32_t number = block.number[k];
        // Beyond the end of a move of a ball another half space would be little closer.
        const bool is_flat = block.flat_radius[k] > 0;
        if (!(gaps.size[k] > 0) || (is_flat && gaps.lost[k] < 0)) {
            found.push_back(
                {number, half_space_beyond(sweeps_[static_cast<std::size_t>(number)],
                                           rays.centre)});
            return;
        }
        const double per_size = 1 / gaps.size[k];
        const Vec3 normal = per_size * Vec3{gaps.x[k], gaps.y[k], gaps.z[k]};
        found.push_back(
            {number, {normal, normal.dot(rays.centre) + per_size * gaps.least[k]}});
    });
    return found;
}

}  // namespace endmill
