// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/turning_tile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "endmill/core/tolerance.h"
#include "endmill/deviation/detail/part_tiles.h"
#include "endmill/deviation/detail/ray_bounds.h"

// The same steps as `TileMeasure`, with bounded rays. Between the rays
// - a gouge is bounded where part and corner are smooth by the circle of `hidden_gouge`,
//   which holds for any motion because the deepest hidden place lies on one pose, else by
//   half spaces that contain what a piece clears;
// - remaining stock is bounded by single pieces: over a flat cell the thickness that a piece
//   leaves is convex but for its turn, so its maximum lies at a corner.
// Cells are refined level by level, with ever smaller errors of the rays.

namespace endmill {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
// First distance between the bounds of a ray, as a share of the smaller limit.
constexpr double first_sharpness_share = 0.05;
// Factor on it for each level of the refinement, as the error of a halved piece.
constexpr double sharpness_factor = 0.25;
constexpr double least_sharpness = 1e-7;  // mm
// As in TileMeasure: a larger cell needs half spaces.
constexpr double planes_share = 0.25;
// Tolerance of a unit normal's z for an upright wall, as in TileMeasure.
constexpr double upright_z = 1e-3;
// Thicknesses below this share of their limit are not limited by an empty ball.
constexpr double limited_share = 0.5;
// Limit of the refined cells of a tile.
constexpr std::size_t most_refined_cells = 5000;
// Rays of a cell lie at most this many times its reach from its middle: the reach comes
// from the partials at the middle.
constexpr double disc_margin = 1.1;
// The thickness is expected to grow by at most these shares of the reach over a cell; where
// it does not, all pieces are looked at.
constexpr double least_rise = 0.2;
constexpr double steepest = 4;
constexpr std::size_t most_pieces = 6;

double positive(double value)
{
    return std::max(0.0, value);
}

}  // namespace

TurningTile::TurningTile(const TurningMeasured& measured, const PartTile& tile)
    : measured_{measured},
      tile_{tile},
      curvature_{greatest_curvature(measured.charts, tile)},
      touches_side_{measured.charts.touches_side(tile.whole)},
      gap_{infinite}
{
    lay_out_rays();
    cut_rays();
}

double TurningTile::sharpness(int level) const
{
    const DeviationLimits& limits = measured_.options.limits;
    return std::max(least_sharpness,
                    first_sharpness_share *
                        (std::min(limits.tolerance, limits.scallop) + verdict_slack) *
                        std::pow(sharpness_factor, level));
}

void TurningTile::lay_out_rays()
{
    const std::vector<PartCell> all = tile_cells(tile_);
    const std::vector<PartRay> rays = tile_rays(measured_.charts, tile_, all);
    cells_.reserve(all.size());
    numbers_.reserve(all.size());
    for (std::size_t k = 0; k < all.size(); ++k) {
        const PartRay& ray = rays[k];
        if (!has_normal(ray))
            continue;
        BoundedCell bounded{{all[k], ray, all[k].reach(ray), {}, curvature_}, {}};
        bounded.cell.in_stock = measured_.initial_ray(ray);
        bounded.cell.area = all[k].area(ray);
        cells_.push_back(bounded);
        numbers_.push_back(static_cast<int>(k));
        centre_ += ray.point;
    }
    if (cells_.empty())
        return;
    centre_ /= static_cast<double>(cells_.size());
    is_wall_ = measured_.is_upright;
    for (const BoundedCell& bounded : cells_) {
        radius_ = std::max(radius_, (bounded.cell.ray.point - centre_).norm());
        is_wall_ = is_wall_ && std::abs(bounded.cell.ray.normal.z()) <= upright_z;
    }
}

void TurningTile::cut_rays()
{
    std::vector<BoundedRay> rays;
    std::vector<double> away;
    rays.reserve(cells_.size());
    away.reserve(cells_.size());
    for (const BoundedCell& bounded : cells_) {
        const double left = bounded.cell.in_stock.thickness;
        rays.push_back({left, left, {}, bounded.cell.in_stock.slope});
        away.push_back((bounded.cell.ray.point - centre_).norm());
    }
    const auto reach = [&] {
        double most = 0;
        for (std::size_t k = 0; k < rays.size(); ++k)
            most = std::max(most, positive(rays[k].low) + away[k]);
        return most;
    };
    const double error = sharpness(0);
    if (!cells_.empty())
        measured_.pieces.visit_nearest(
            centre_, infinite, [&](std::size_t number, double bound) {
                gap_ = std::min(gap_, bound - radius_);
                const ToolPiece& piece = measured_.pieces.pieces()[number];
                const PieceDistance nearest = distance_from(piece, centre_, reach());
                const Vec3 out = piece.motion.at(nearest.at).axes * nearest.out;
                for (std::size_t k = 0; k < rays.size(); ++k) {
                    const PartRay& ray = cells_[k].cell.ray;
                    const double length = positive(rays[k].low);
                    const double least = nearest.lower + out.dot(ray.point - centre_) +
                                         std::min(0.0, out.dot(ray.normal)) * length -
                                         2 * nearest.slack * (away[k] + length);
                    if (least <= 0)
                        cut(rays[k], ray, piece, error);
                }
                return reach();
            });
    for (std::size_t k = 0; k < cells_.size(); ++k)
        take_ray(cells_[k], rays[k]);
}

// Stores a cut ray in its cell.
void TurningTile::take_ray(BoundedCell& bounded, const BoundedRay& ray) const
{
    bounded.ray = ray;
    bounded.cell.cut = {ray.high, ray.slope, ray.piece ? ray.piece->point : -1};
    set_judged(bounded.cell);
    limit(bounded);
}

void TurningTile::set_judged(MeasuredCell& cell) const
{
    const double half = measured_.options.pitch / 2;
    cell.is_skipped = is_skipped(measured_.charts, cell.cell.chart, measured_.options);
    cell.is_outer = is_wall_ && !measured_.distance.is_over_or_under(
                                    cell.ray.point + half * cell.ray.normal);
    const auto& is_accessible = measured_.options.is_accessible;
    cell.is_inaccessible =
        !cell.is_skipped && !cell.is_outer && is_accessible &&
        cell.cut.thickness > reached_share * measured_.options.limits.scallop &&
        !is_accessible(cell.ray);
}

// Limits both bounds to the largest empty ball at the ray's point.
void TurningTile::limit(BoundedCell& bounded) const
{
    const DeviationLimits& limits = measured_.options.limits;
    const PartRay& at = bounded.cell.ray;
    BoundedRay& ray = bounded.ray;
    std::optional<std::size_t> no_hint;
    const auto free = [&](double sign, double length) {
        return measured_.distance.free_ball({at.point, sign * at.normal, length}, no_hint)
            .length;
    };
    if (ray.high > limited_share * limits.scallop && bounded.cell.is_judged()) {
        const double length = free(+1, ray.high);
        ray.high = std::min(ray.high, length + measured_.distance.uncertainty());
        ray.low = std::min(ray.low, length);
    }
    if (-ray.low > limited_share * limits.tolerance) {
        const double length = free(-1, -ray.low);
        ray.low = std::max(ray.low, -length - measured_.distance.uncertainty());
        ray.high = std::max(ray.high, -length);
    }
}

// Returns the rays of a cell and its quarters.
RayDisc TurningTile::disc_of(const BoundedCell& bounded) const
{
    const MeasuredCell& cell = bounded.cell;
    const double reach = disc_margin * cell.reach;
    const double bend = reach * cell.curvature.absolute;
    const double length = positive(bounded.ray.high) +
                          reach * (least_rise + std::min(bounded.ray.slope, steepest));
    return {cell.ray.point, cell.ray.normal, reach, length, reach * bend / 2, bend};
}

// Returns the pieces that may reach rays of the tile and its cells.
TurningTile::Near TurningTile::near_pieces() const
{
    RayDisc rays{centre_, Vec3::Zero(), 0, 0, 0, 0};
    for (const BoundedCell& bounded : cells_) {
        const RayDisc of_cell = disc_of(bounded);
        rays.reach =
            std::max(rays.reach, (of_cell.centre - centre_).norm() + of_cell.reach);
        rays.length = std::max(rays.length, of_cell.length);
        rays.normal += of_cell.normal;
    }
    rays.normal = unit_or_up(rays.normal);
    for (const BoundedCell& bounded : cells_) {
        const PartRay& ray = bounded.cell.ray;
        const RayDisc of_cell = disc_of(bounded);
        const double tilt = (ray.normal - rays.normal).norm() + of_cell.tilt;
        rays.tilt = std::max(rays.tilt, tilt);
        rays.sag = std::max(rays.sag, std::abs((ray.point - centre_).dot(rays.normal)) +
                                          of_cell.reach * tilt);
    }
    auto near = std::make_shared<NearPieces>(NearPieces{rays, {}});
    const double within = rays.reach + rays.length;
    measured_.pieces.visit_nearest(centre_, within, [&](std::size_t number, double) {
        if (may_reach(measured_.pieces.pieces()[number], rays))
            near->pieces.push_back(static_cast<std::uint32_t>(number));
        return within;
    });
    return near;
}

// Returns the pieces of a list that may reach the rays of a cell and its quarters.
TurningTile::Near TurningTile::nearer(const BoundedCell& bounded,
                                      const NearPieces& of) const
{
    auto near = std::make_shared<NearPieces>(NearPieces{disc_of(bounded), {}});
    near->rays.length = std::min(near->rays.length, of.rays.length);
    near->rays.reach =
        std::min(near->rays.reach,
                 of.rays.reach - (bounded.cell.ray.point - of.rays.centre).norm());
    for (const std::uint32_t number : of.pieces)
        if (may_reach(measured_.pieces.pieces()[number], near->rays))
            near->pieces.push_back(number);
    return near;
}

// Measures a cell by near pieces; by all pieces if others could matter.
BoundedCell TurningTile::measured(const PartCell& cell, const PartRay& ray,
                                  const NearPieces& near, int level) const
{
    BoundedCell bounded{{cell, ray, cell.reach(ray), {}, curvature_}, {}};
    bounded.cell.in_stock = measured_.initial_ray(ray);
    bounded.cell.area = cell.area(ray);
    const double left = bounded.cell.in_stock.thickness;
    BoundedRay cut_ray{left, left, {}, bounded.cell.in_stock.slope};
    const double error = sharpness(level);
    const std::span<const ToolPiece> pieces = measured_.pieces.pieces();
    for (const std::uint32_t number : near.pieces)
        cut(cut_ray, ray, pieces[number], error);
    if (!near.is_for(ray, positive(cut_ray.low)))
        measured_.pieces.visit_nearest(ray.point, positive(cut_ray.low),
                                       [&](std::size_t number, double) {
                                           cut(cut_ray, ray, pieces[number], error);
                                           return positive(cut_ray.low);
                                       });
    take_ray(bounded, cut_ray);
    return bounded;
}

// Whether a gouge may be deeper beside what is visible at the middle.
bool TurningTile::needs_planes(const BoundedCell& bounded) const
{
    return measured_.corner_radius == 0 ||
           bounded.cell.reach > planes_share * measured_.corner_radius ||
           (touches_side_ && measured_.charts.touches_side(bounded.cell.cell));
}

// Upper bound of the thickness on a cell by the piece at its middle, and by the stock.
double TurningTile::most_left(const BoundedCell& bounded) const
{
    const MeasuredCell& cell = bounded.cell;
    if (!cell.is_judged())
        return 0;
    const double in_stock =
        cell.in_stock.thickness + cell.reach * (1 + cell.in_stock.slope);
    const ToolPiece* piece = bounded.ray.piece;
    // At the upper end of a finite cutter no ball of the corner radius fits inside.
    const bool is_finite = piece && std::isfinite(piece->body.length());
    const double by_slope =
        is_finite
            ? infinite
            : most_left_by_slope(cell, piece ? piece->body.cutter() : Cutter::flat(1));
    const double most = std::min(in_stock, by_slope);
    if (piece && (piece->body.cutter().is_flat() || is_finite))
        return std::min(most, most_left_by_pieces(bounded, {&piece, 1}));
    return most;
}

// Upper bound by the least of single pieces, and of convex combinations of two.
double TurningTile::most_left_by_pieces(const BoundedCell& bounded,
                                        std::span<const ToolPiece* const> pieces) const
{
    const MeasuredCell& cell = bounded.cell;
    const auto rays = corner_rays(cell.cell, measured_.charts);
    if (!rays)
        return infinite;
    double least = infinite;
    std::vector<CornerValues> values;
    values.reserve(pieces.size());
    const double before = bounded.ray.high + owner_margin(cell);
    const double near = 2 * cell.reach + positive(before);
    for (const ToolPiece* piece : pieces) {
        CornerValues value{{-infinite, -infinite, -infinite, -infinite}};
        bool is_low = true;
        for (std::size_t k = 0; k < static_cast<std::size_t>(cell.cell.corners) && is_low;
             ++k) {
            const auto left = thickness_by(*piece, (*rays)[k], near, before);
            is_low = left.has_value();
            value.at[k] = left.value_or(infinite);
        }
        if (!is_low)
            continue;
        least = std::min(least, value.most());
        for (const CornerValues& other : values)
            least = std::min(least, least_of_means(value, other, cell.cell.corners));
        values.push_back(value);
    }
    return least + cell.reach * cell.reach * cell.curvature.absolute;
}

// Returns the pieces that leave the least at the cell's middle, the lowest first.
std::vector<const ToolPiece*> TurningTile::lowest_pieces(const BoundedCell& bounded,
                                                         const NearPieces& near) const
{
    const double before = bounded.ray.high + owner_margin(bounded.cell);
    std::vector<std::pair<double, const ToolPiece*>> found;
    for (const std::uint32_t number : near.pieces) {
        BoundedRay alone{before, before};
        cut(alone, bounded.cell.ray, measured_.pieces.pieces()[number],
            std::max(least_sharpness, owner_margin(bounded.cell)));
        if (alone.piece)
            found.emplace_back(alone.high, alone.piece);
    }
    std::ranges::stable_sort(
        found, [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<const ToolPiece*> lowest;
    for (std::size_t k = 0; k < std::min(most_pieces, found.size()); ++k)
        lowest.push_back(found[k].second);
    return lowest;
}

namespace {

// Lower bound, below 0, of the thickness that a piece leaves anywhere on a cell. As in
// `least_left_by_planes`, three half spaces are tried, and one parallel to the cell: beside
// a sharp rim that touches the part only this one is near.
double least_by_piece(const MeasuredCell& cell, const ToolPiece& piece)
{
    const auto by = [&](const Vec3& place) {
        const PieceDistance nearest = distance_from(piece, place, infinite);
        const Vec3 out = piece.motion.at(nearest.at).axes * nearest.out;
        const double length = out.norm();
        return length > 0 ? least_by(cell, half_space_of(piece, -out / length))
                          : -infinite;
    };
    const Vec3& middle = cell.ray.point;
    double known = by(middle);
    if (known == infinite)
        return known;
    known = std::max(known, least_by(cell, half_space_of(piece, cell.ray.normal)));
    known = std::max(known, by(middle - piece.body.cutter().radius() * cell.ray.normal));
    if (!std::isfinite(known))
        return known;
    return std::max(known, by(middle + known * cell.ray.normal));
}

// The same for a piece that is halved while the bound is below `enough` and the turn may
// change it by more than `sharpness` mm.
double least_by_halves(const MeasuredCell& cell, const ToolPiece& piece, double enough,
                       double sharpness)
{
    const double least = least_by_piece(cell, piece);
    if (least >= enough || !(half_space_slack(piece) > sharpness))
        return least;
    double of_halves = infinite;
    for (const ToolMotion& half : piece.motion.halves()) {
        of_halves = std::min(
            of_halves, least_by_halves(cell, {half, piece.body, piece.point, piece.order},
                                       enough, sharpness));
        if (of_halves <= least)
            return least;
    }
    return of_halves;
}

}  // namespace

double TurningTile::least_left(const BoundedCell& bounded, const NearPieces& near,
                               bool by_planes, double enough, double sharpness) const
{
    const MeasuredCell& cell = bounded.cell;
    if (!by_planes)
        return bounded.ray.low - hidden_gouge(cell, measured_.corner_radius);
    double least = std::min(bounded.ray.low, 0.0);
    RayDisc points = disc_of(bounded);
    points.length = 0;
    for (const std::uint32_t number : near.pieces) {
        const ToolPiece& piece = measured_.pieces.pieces()[number];
        if (may_reach(piece, points))
            least = std::min(least, least_by_halves(cell, piece, enough, sharpness));
    }
    return least;
}

// Whether no place `away` mm over the part (below 0: in the part) has its nearest place of
// the part on the cell; see TileMeasure.
bool TurningTile::has_no_foot(const MeasuredCell& cell, double away) const
{
    const double moves = cell.reach * (1 + std::abs(away) * cell.curvature.absolute);
    if (!(moves < std::abs(away)) || !std::isfinite(away))
        return false;
    std::optional<std::size_t> no_hint;
    return measured_.distance(cell.ray.point + away * cell.ray.normal, no_hint) + moves <
           std::abs(away);
}

TurningTile::Bounds TurningTile::bounds(const BoundedCell& bounded,
                                        const NearPieces& near, bool by_planes,
                                        const RefinementThresholds& thresholds,
                                        int level) const
{
    Bounds bounds{most_left(bounded), least_left(bounded, near, by_planes,
                                                 thresholds.lower, sharpness(level))};
    if (bounds.most > thresholds.upper) {
        const std::vector<const ToolPiece*> lowest = lowest_pieces(bounded, near);
        bounds.most = std::min(bounds.most, most_left_by_pieces(bounded, lowest));
    }
    if (bounds.most > thresholds.upper && has_no_foot(bounded.cell, thresholds.upper))
        bounds.most = thresholds.upper;
    if (bounds.least < thresholds.lower && has_no_foot(bounded.cell, thresholds.lower))
        bounds.least = thresholds.lower;
    return bounds;
}

void TurningTile::take(Extremes& found, const BoundedCell& bounded) const
{
    const MeasuredCell& cell = bounded.cell;
    ++found.rays;
    found.top = std::max(found.top, cell.ray.point.z() + cell.reach);
    found.is_cut = found.is_cut || cell.cut.sweep >= 0;
    const auto place = [&](double left) {
        return DeviationPlace{left, cell.ray, cell.cell.chart, cell.cell.centre(),
                              cell.cut.sweep};
    };
    const double low =
        cell.is_judged() ? bounded.ray.low : std::min(bounded.ray.low, 0.0);
    if (low > found.highest.left)
        found.highest = place(low);
    if (bounded.ray.high < found.deepest.left)
        found.deepest = place(bounded.ray.high);
}

Extremes TurningTile::extremes() const
{
    Extremes found;
    for (const BoundedCell& bounded : cells_) {
        take(found, bounded);
        const bool by_planes = needs_planes(bounded);
        if (by_planes && !near_)
            near_ = near_pieces();
        const double least =
            by_planes
                ? least_left(bounded, *near_, true, -infinite, infinite)
                : bounded.ray.low - hidden_gouge(bounded.cell, measured_.corner_radius);
        found.bound(most_left(bounded), least);
        found.add_area(bounded.value(), bounded.cell.area, measured_.options.limits);
    }
    return found;
}

void TurningTile::add_quarters(const Refined& of, int level,
                               std::vector<Refined>& next) const
{
    for (const PartCell& quarter : of.bounded.cell.cell.quarters()) {
        const auto ray = measured_.charts.ray(quarter.chart, quarter.centre());
        if (!ray)
            continue;
        const bool is_strip =
            level == 1 && of.at_border && measured_.charts.runs_along_border(quarter);
        const BoundedCell bounded = measured(quarter, *ray, *of.near, level);
        next.push_back(
            {bounded, nearer(bounded, *of.near), of.at_border, of.is_strip || is_strip});
    }
}

void TurningTile::add_leaf(Extremes& found, const Refined& leaf,
                           const Bounds& bounds) const
{
    found.bound(bounds.most, bounds.least);
    if (!leaf.is_strip)
        found.add_area(leaf.bounded.value(), leaf.bounded.cell.area,
                       measured_.options.limits);
}

Extremes TurningTile::refined(const RefinementThresholds& thresholds) const
{
    Extremes found;
    const Near near = near_pieces();
    std::vector<Refined> level_cells;
    level_cells.reserve(cells_.size());
    for (const BoundedCell& bounded : cells_) {
        const BoundedCell sharp = measured(bounded.cell.cell, bounded.cell.ray, *near, 0);
        const bool at_border =
            touches_side_ && measured_.charts.touches_border(bounded.cell.cell);
        level_cells.push_back({sharp, nearer(sharp, *near), at_border, false});
    }
    std::size_t refined_cells = 0;
    for (int level = 0; !level_cells.empty(); ++level) {
        std::vector<Bounds> of_cell;
        of_cell.reserve(level_cells.size());
        std::size_t exceeding = 0;
        for (const Refined& one : level_cells) {
            if (!one.is_strip)
                take(found, one.bounded);
            const bool by_planes = one.at_border || needs_planes(one.bounded);
            of_cell.push_back(
                bounds(one.bounded, *one.near, by_planes, thresholds, level));
            if (thresholds.are_exceeded(of_cell.back().most, of_cell.back().least))
                ++exceeding;
        }
        refined_cells += 4 * exceeding;
        const bool is_last =
            level >= measured_.options.max_refine || refined_cells > most_refined_cells;
        std::vector<Refined> next;
        for (std::size_t k = 0; k < level_cells.size(); ++k) {
            const Bounds& bounds = of_cell[k];
            if (is_last || !thresholds.are_exceeded(bounds.most, bounds.least))
                add_leaf(found, level_cells[k], bounds);
            else
                add_quarters(level_cells[k], level + 1, next);
        }
        level_cells = std::move(next);
    }
    return found;
}

}  // namespace endmill
