// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/sweep_rows.h"

#include "endmill/core/detail/widest_registers.h"
#include "endmill/stock/detail/tile_heights.h"

namespace endmill {
namespace {

// Pointers to the arrays of `SweepRows`.
struct SweepPointers {
    const double* x;
    const double* y;
    const double* z;
    const double* dx;
    const double* dy;
    const double* dz;
    const double* per_squared;
    const double* per_level;
    const double* flat_radius;
    const double* corner_radius;
    std::size_t count;
};

double reciprocal(double value)
{
    // For shorter moves the position on the move does not matter, and the reciprocal
    // would overflow.
    return value > 1 / std::numeric_limits<double>::max() ? 1 / value : 0;
}

// Computes the distance of each sweep from the reach of the rays, times the length of the
// direction that is used: the half space of `half_space`, against the bounds of
// `RayBounds::is_out_of_reach`. A value of 0 or more is certain.
ENDMILL_WIDEST_REGISTERS
void measure_gaps(const RayBounds rays, const SweepPointers sweeps,
                  double* __restrict gaps)
{
    const double cx = rays.centre.x();
    const double cy = rays.centre.y();
    const double cz = rays.centre.z();
    const double ux = rays.upright.x();
    const double uy = rays.upright.y();
    const double uz = rays.upright.z();
    for (std::size_t k = 0; k < sweeps.count; ++k) {
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
        const double rate = along + rays.tilt * size;
        const double most = rays.beside * std::sqrt(ax * ax + ay * ay + az * az) +
                            rays.above * std::abs(along) +
                            rays.longest * select(rate > 0, rate, 0);
        gaps[k] = select(size > 0, least - most, -1);
    }
}

}  // namespace

SweepRows::SweepRows(const SweepTree& tree, const RayBounds& rays)
{
    if (tree.sweeps().empty())
        return;
    tree.visit(
        rays.centre,
        [&](const Vec3& nearest, const Cutter& cutter) {
            return !rays.is_out_of_reach(half_space(cutter, rays.centre, nearest), 0,
                                         rays.longest);
        },
        [&](std::size_t number) {
            const StraightSweep& sweep = tree.sweeps()[number];
            if (!rays.is_out_of_reach(half_space_beyond(sweep, rays.centre), 0,
                                      rays.longest))
                add(sweep, static_cast<std::int32_t>(number));
        });
}

void SweepRows::add(const StraightSweep& sweep, std::int32_t number)
{
    const Vec3 move = sweep.to() - sweep.from();
    rows_.x.push_back(sweep.from().x());
    rows_.y.push_back(sweep.from().y());
    rows_.z.push_back(sweep.from().z() + sweep.cutter().corner_radius());
    rows_.dx.push_back(move.x());
    rows_.dy.push_back(move.y());
    rows_.dz.push_back(move.z());
    rows_.per_squared.push_back(reciprocal(move.squaredNorm()));
    rows_.per_level.push_back(reciprocal(move.head<2>().squaredNorm()));
    rows_.flat_radius.push_back(sweep.cutter().flat_radius());
    rows_.corner_radius.push_back(sweep.cutter().corner_radius());
    numbers_.push_back(number);
}

std::vector<std::int32_t> SweepRows::near(const RayBounds& rays) const
{
    std::vector<double> gaps(numbers_.size());
    measure_gaps(
        rays,
        {rows_.x.data(), rows_.y.data(), rows_.z.data(), rows_.dx.data(), rows_.dy.data(),
         rows_.dz.data(), rows_.per_squared.data(), rows_.per_level.data(),
         rows_.flat_radius.data(), rows_.corner_radius.data(), numbers_.size()},
        gaps.data());
    std::vector<std::int32_t> near;
    for (std::size_t k = 0; k < gaps.size(); ++k)
        if (!(gaps[k] >= 0))
            near.push_back(numbers_[k]);
    return near;
}

}  // namespace endmill
