// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/sweep_rows.h"

#include <algorithm>
#include <limits>

#include "endmill/core/detail/widest_registers.h"
#include "endmill/stock/detail/tile_heights.h"

namespace endmill {
namespace {

// Number of sweeps that are tested at a time.
constexpr std::size_t block_size = 64;
using Block = std::array<double, block_size>;
// Number of `flat_radius` among the columns.
constexpr std::size_t flat_radius_column = 8;

// The half spaces of a block of sweeps. All but `size` are multiplied by `size`.
struct Gaps {
    Block gap;    // distance from the reach of the rays; below 0 a sweep may reach them
    Block x;      // normal
    Block y;      // normal
    Block z;      // normal
    Block size;   // length of the direction to the sweep, mm
    Block least;  // as in HalfSpace, from the centre of the rays
    // Below 0 if the normal is not perpendicular to the move. Another normal may then be
    // better.
    Block lost;
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
void measure_gaps(const RayBounds& rays, const SweepRows::Columns& sweeps,
                  std::size_t count, Gaps& gaps)
{
    const double cx = rays.centre.x();
    const double cy = rays.centre.y();
    const double cz = rays.centre.z();
    const double ux = rays.upright.x();
    const double uy = rays.upright.y();
    const double uz = rays.upright.z();
    const double tilt = rays.tilt;
    const double rays_beside = rays.beside;
    const double rays_above = rays.above;
    const double longest = rays.longest;
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

}  // namespace

// Calls `visit(row, gaps, place of the row in them)` for each row that may clear a point of
// the rays.
template <typename Visit>
void SweepRows::visit_near(const RayBounds& rays, const Visit& visit) const
{
    Gaps gaps;
    for (std::size_t first = 0; first < numbers_.size(); first += block_size) {
        const std::size_t count = std::min(block_size, numbers_.size() - first);
        measure_gaps(rays, columns_from(first), count, gaps);
        for (std::size_t k = 0; k < count; ++k)
            if (!(gaps.gap[k] >= 0))
                visit(first + k, gaps, k);
    }
}

SweepRows::SweepRows(const SweepTree& tree, const RayBounds& rays)
    : SweepRows{tree.sweeps()}
{
    if (sweeps_.empty())
        return;
    SweepRows all{sweeps_};
    tree.visit(
        rays.centre,
        [&](const Vec3& nearest, const Cutter& cutter) {
            return !rays.is_out_of_reach(half_space(cutter, rays.centre, nearest), 0,
                                         rays.longest);
        },
        [&](std::size_t number) {
            all.numbers_.push_back(static_cast<std::int32_t>(number));
        });
    all.fill();
    *this = all.reduced(rays);
}

SweepRows::Columns SweepRows::columns_from(std::size_t first) const
{
    const auto at = [&](std::size_t column) { return column_begin(column) + first; };
    return {at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7), at(8), at(9)};
}

// Computes the columns, in the order of `Columns`.
void SweepRows::fill()
{
    rows_.resize(columns * numbers_.size());
    for (std::size_t k = 0; k < numbers_.size(); ++k) {
        const StraightSweep& sweep = sweeps_[static_cast<std::size_t>(numbers_[k])];
        const Vec3 move = sweep.to() - sweep.from();
        const double corner = sweep.cutter().corner_radius();
        const std::array<double, columns> row{sweep.from().x(),
                                              sweep.from().y(),
                                              sweep.from().z() + corner,
                                              move.x(),
                                              move.y(),
                                              move.z(),
                                              reciprocal(move.squaredNorm()),
                                              reciprocal(move.head<2>().squaredNorm()),
                                              sweep.cutter().flat_radius(),
                                              corner};
        for (std::size_t c = 0; c < columns; ++c)
            rows_[c * numbers_.size() + k] = row[c];
    }
}

SweepRows SweepRows::reduced(const RayBounds& rays) const
{
    std::vector<std::size_t> kept;
    kept.reserve(numbers_.size());
    visit_near(rays,
               [&](std::size_t row, const Gaps&, std::size_t) { kept.push_back(row); });
    SweepRows some{sweeps_};
    some.numbers_.resize(kept.size());
    some.rows_.resize(columns * kept.size());
    for (std::size_t k = 0; k < kept.size(); ++k)
        some.numbers_[k] = numbers_[kept[k]];
    double* to = some.rows_.data();
    for (std::size_t c = 0; c < columns; ++c) {
        const double* from = column_begin(c);
        for (const std::size_t row : kept)
            *to++ = from[row];
    }
    return some;
}

std::vector<NearSweep> SweepRows::near(const RayBounds& rays) const
{
    std::vector<NearSweep> found;
    visit_near(rays, [&](std::size_t row, const Gaps& gaps, std::size_t k) {
        const std::int32_t number = numbers_[row];
        // Beyond the end of a move of a ball another half space would be little closer.
        const bool is_flat = column_begin(flat_radius_column)[row] > 0;
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
