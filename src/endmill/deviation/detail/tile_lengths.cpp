// SPDX-License-Identifier: GPL-3.0-or-later
// What TileMeasure does to find how much of each ray counts.
#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "endmill/deviation/detail/free_lengths.h"
#include "endmill/deviation/detail/tile_measure.h"

namespace endmill {
namespace {

// A ball of three times the rays' length, or this much of a tile's half diagonal, that
// touches the tile's middle covers all balls a third as large that touch the tile, but for
// what lies within the other share of the half diagonal beside the tile, and in a layer of
// less height over it. It may be a little smaller, in such shares.
constexpr double ball_shares = 3;
constexpr double ball_sizes = 5.2;
constexpr double layer_sizes = 2;
constexpr double spared_sizes = 0.25;
// Of a sphere's curvature of the same radius: the part then stays well under the ball.
constexpr double bend_share = 0.5;
// Of the rays' length: those of finer cells are somewhat longer.
constexpr double longer = 1.5;

}  // namespace

void TileMeasure::count(std::optional<std::size_t>& hint)
{
    count_side(+1, hint);
    count_side(-1, hint);
}

void TileMeasure::count_side(double sign, std::optional<std::size_t>& hint)
{
    const auto counts = [sign](const MeasuredCell& cell) {
        return sign * cell.left.left > negligible_length && !(sign > 0 && cell.is_outer);
    };
    double longest = 0;
    for (const MeasuredCell& cell : cells_)
        if (counts(cell))
            longest = std::max(longest, sign * cell.left.left);
    if (!(longest > 0) || is_free(sign, longest))
        return;
    std::vector<PartWay> ways;
    std::vector<MeasuredCell*> counted;
    ways.reserve(cells_.size());
    counted.reserve(cells_.size());
    for (MeasuredCell& cell : cells_)
        if (counts(cell)) {
            ways.push_back(
                {cell.ray.point, sign * cell.ray.normal, sign * cell.left.left});
            counted.push_back(&cell);
        }
    const std::vector<FreeLength> lengths = free_lengths(ways, measured_.distance, hint);
    for (std::size_t k = 0; k < counted.size(); ++k) {
        counted[k]->nearer = sign * lengths[k].length;
        counted[k]->is_measured = lengths[k].is_measured;
    }
}

// Whether no ray of the tile, up to `length` on that side, can be shortened. If not, one may
// be all the same.
bool TileMeasure::is_free(double sign, double length)
{
    std::optional<double>& free = free_[sign > 0 ? 0 : 1];
    if (!free)
        free = measured_free(sign);
    return length <= *free;
}

double TileMeasure::measured_free(double sign) const
{
    const PartCell& whole = tile_.whole;
    const auto middle = measured_.charts.ray(whole.chart, whole.centre());
    if (!middle || !rays_)
        return 0;
    double length = 0;
    for (const MeasuredCell& cell : cells_)
        length = std::max(length, longer * sign * cell.left.left);
    const double size = whole.reach(*middle);
    const double radius = std::max(ball_shares * length, ball_sizes * size);
    if (bend_.any * radius > bend_share || !is_smooth_within(layer_sizes * size, *middle))
        return 0;
    const Vec3 centre = middle->point + sign * radius * middle->normal;
    return measured_.distance.is_clear(centre, radius - spared_sizes * size)
               ? radius / ball_shares
               : 0;
}

// Whether the tile's own patch goes on so far around it.
bool TileMeasure::is_smooth_within(double distance, const PartRay& middle) const
{
    if (measured_.charts.mesh())
        return false;
    const double area = middle.du.cross(middle.dv).norm();
    const Eigen::Vector2d more{distance * middle.dv.norm() / area,
                               distance * middle.du.norm() / area};
    PartCell wide = tile_.whole;
    const Eigen::Vector2d centre = wide.centre();
    for (Eigen::Vector2d& at : wide.at)
        for (int c = 0; c < 2; ++c)
            at[c] += at[c] > centre[c] ? more[c] : -more[c];
    return !measured_.charts.touches_side(wide);
}

// Only where it tells something new: it takes time.
void TileMeasure::find_nearer(MeasuredCell& cell, const Extremes& found)
{
    const double left = cell.left.left;
    const bool is_news = left > std::max(known_.scallop, found.highest.left) ||
                         -left > std::max(known_.tolerance, -found.deepest.left) ||
                         is_beyond(left, limits());
    if (!is_news || cell.nearer || std::abs(left) <= negligible_length ||
        (left > 0 && cell.is_outer) || is_free(left < 0 ? -1 : 1, std::abs(left)))
        return;
    std::optional<std::size_t> no_hint;
    cell.nearer = shortened(left, cell.ray, measured_.distance, no_hint);
}

}  // namespace endmill
