// SPDX-License-Identifier: GPL-3.0-or-later
// Limits of TileMeasure: how much of each ray counts. A thickness counts up to the radius
// of the largest empty ball that touches the part at the ray's point. A query per ray
// would be slow. Usually one query per tile suffices: a large empty ball over the middle
// of the tile contains the balls of all rays (`measured_free`). Only where it is not
// empty are the rays measured, and then only some of them (`free_lengths`).
#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "endmill/deviation/detail/free_lengths.h"
#include "endmill/deviation/detail/tile_measure.h"

namespace endmill {
namespace {

// Thicknesses up to this length in mm are not limited by an empty ball: it is far below
// verdict_slack.
constexpr double negligible_length = 1e-6;

// Let s be half the diagonal of a tile, and rho the radius of a ball that touches the
// tile's middle. All balls of radius rho / 3 that touch the tile lie in the large ball if
// rho is at least 5.2 s, except in a layer of less than s over the tile and at most 2 s
// beside it. The large ball may be smaller by 0.25 s.
// Source: paper/notes/deviation-bounds.md, "All rays count so".
constexpr double ball_shares = 3;
constexpr double ball_sizes = 5.2;
constexpr double layer_sizes = 2;
constexpr double spared_sizes = 0.25;
// Greatest curvature of the part times the ball's radius. The part then stays well below
// the ball.
constexpr double bend_share = 0.5;
// Factor on the rays' length, because rays of finer cells are somewhat longer.
constexpr double longer = 1.5;

}  // namespace

void TileMeasure::limit_thicknesses(std::optional<std::size_t>& hint)
{
    limit_side(+1, hint);
    limit_side(-1, hint);
}

// Limits the thickness (sign +1) or the depth (sign -1) of the cells.
void TileMeasure::limit_side(double sign, std::optional<std::size_t>& hint)
{
    const auto counts = [sign](const MeasuredCell& cell) {
        return sign * cell.cut.thickness > negligible_length &&
               !(sign > 0 && (cell.is_outer || cell.is_skipped));
    };
    double longest = 0;
    for (const MeasuredCell& cell : cells_)
        if (counts(cell))
            longest = std::max(longest, sign * cell.cut.thickness);
    if (!(longest > 0) || is_free(sign, longest))
        return;
    std::vector<PartWay> ways;
    std::vector<MeasuredCell*> counted;
    ways.reserve(cells_.size());
    counted.reserve(cells_.size());
    for (MeasuredCell& cell : cells_)
        if (counts(cell)) {
            ways.push_back(
                {cell.ray.point, sign * cell.ray.normal, sign * cell.cut.thickness});
            counted.push_back(&cell);
        }
    const std::vector<FreeLength> lengths = free_lengths(ways, measured_.distance, hint);
    for (std::size_t k = 0; k < counted.size(); ++k) {
        counted[k]->limited = sign * lengths[k].length;
        counted[k]->is_measured = lengths[k].is_measured;
    }
}

// Whether no ray of the tile up to `length` on that side is limited. A negative answer is
// not certain.
bool TileMeasure::is_free(double sign, double length)
{
    std::optional<double>& free = free_[sign > 0 ? 0 : 1];
    if (!free)
        free = measured_free(sign);
    return length <= *free;
}

// Returns the length up to which no ray on that side is limited, in mm; 0 if not known.
double TileMeasure::measured_free(double sign) const
{
    const PartCell& whole = tile_.whole;
    const auto middle = measured_.charts.ray(whole.chart, whole.centre());
    if (!middle || !rays_)
        return 0;
    double length = 0;
    for (const MeasuredCell& cell : cells_)
        length = std::max(length, longer * sign * cell.cut.thickness);
    const double size = whole.reach(*middle);
    const double radius = std::max(ball_shares * length, ball_sizes * size);
    if (curvature_.absolute * radius > bend_share ||
        !is_smooth_within(layer_sizes * size, *middle))
        return 0;
    const Vec3 centre = middle->point + sign * radius * middle->normal;
    return measured_.distance.is_clear(centre, radius - spared_sizes * size)
               ? radius / ball_shares
               : 0;
}

// Whether the tile's patch continues for this distance around the tile.
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

// Limits the thickness of one cell, but only if it could change a maximum or violates a
// limit, because the query takes time.
void TileMeasure::limit_thickness(MeasuredCell& cell, const Extremes& found)
{
    const double left = cell.cut.thickness;
    const bool is_news = left > std::max(known_.scallop, found.highest.left) ||
                         -left > std::max(known_.tolerance, -found.deepest.left) ||
                         is_beyond(left, limits());
    if (!is_news || cell.limited || std::abs(left) <= negligible_length ||
        (left > 0 && !cell.is_judged()) || is_free(left < 0 ? -1 : 1, std::abs(left)))
        return;
    std::optional<std::size_t> no_hint;
    cell.limited = limited_thickness(left, cell.ray, measured_.distance, no_hint);
}

}  // namespace endmill
