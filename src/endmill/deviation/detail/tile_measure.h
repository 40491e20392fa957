// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "endmill/deviation/detail/cell_bounds.h"
#include "endmill/deviation/detail/cut_rays.h"
#include "endmill/deviation/detail/part_distance.h"
#include "endmill/deviation/deviation.h"

namespace endmill {

/// Extreme thicknesses found on some cells, with their bounds.
struct Extremes {
    /// Place of the greatest thickness.
    DeviationPlace highest{-std::numeric_limits<double>::infinity()};
    /// Place of the smallest thickness.
    DeviationPlace deepest{std::numeric_limits<double>::infinity()};
    /// Upper bound of thickness, mm.
    double upper = -std::numeric_limits<double>::infinity();
    /// Lower bound of thickness, mm.
    double lower = std::numeric_limits<double>::infinity();
    double gouge_area = 0;  ///< mm^2, cells with a gouge deeper than the tolerance
    double uncut_area = 0;  ///< mm^2, cells with more left than the scallop limit
    /// Upper bound of the cells' z, mm.
    double top = -std::numeric_limits<double>::infinity();
    bool is_cut = false;   ///< whether a move reaches a ray
    std::size_t rays = 0;  ///< number of measured rays

    /// Adds the ray at the middle of a cell.
    void take(const MeasuredCell& cell)
    {
        ++rays;
        top = std::max(top, cell.ray.point.z() + cell.reach);
        is_cut = is_cut || cell.cut.sweep >= 0;
        const double left = cell.value();
        if (left > highest.left || left < deepest.left)
            take(DeviationPlace{left, cell.ray, cell.cell.chart, cell.cell.centre(),
                                cell.cut.sweep});
    }
    /// Updates the extreme places.
    void take(const DeviationPlace& place)
    {
        if (place.left > highest.left)
            highest = place;
        if (place.left < deepest.left)
            deepest = place;
    }
    /// Adds the bounds of a cell.
    void bound(double most, double least)
    {
        upper = std::max(upper, most);
        lower = std::min(lower, least);
    }
    /// Adds the area of a cell, in mm^2, with this thickness at its middle, in mm.
    void add_area(double left, double area, const DeviationLimits& limits)
    {
        if (-left > limits.tolerance)
            gouge_area += area;
        if (left > limits.scallop)
            uncut_area += area;
    }
    /// Combines two results for the same cells: both hold, so the closer bounds and the
    /// larger areas are kept.
    void join(const Extremes& other)
    {
        const double most = std::min(upper, other.upper);
        const double least = std::max(lower, other.lower);
        const double gouged = std::max(gouge_area, other.gouge_area);
        const double uncut = std::max(uncut_area, other.uncut_area);
        merge(other);
        gouge_area = gouged;
        uncut_area = uncut;
        upper = std::max(most, highest.left);
        lower = std::min(least, deepest.left);
    }
    /// Combines the results of two sets of cells. Of equal extremes the first stays, so
    /// the order of the calls decides.
    void merge(const Extremes& other)
    {
        if (other.highest.left > highest.left)
            highest = other.highest;
        if (other.deepest.left < deepest.left)
            deepest = other.deepest;
        upper = std::max(upper, other.upper);
        lower = std::min(lower, other.lower);
        gouge_area += other.gouge_area;
        uncut_area += other.uncut_area;
        top = std::max(top, other.top);
        is_cut = is_cut || other.is_cut;
        rays += other.rays;
    }
};

/// Thicknesses beyond which the bounds of a cell require its refinement.
struct RefinementThresholds {
    double upper;  ///< mm, at least 0
    double lower;  ///< mm, at most 0

    /// Whether a cell with these bounds of its thickness must be refined.
    bool are_exceeded(double most, double least) const
    {
        return most > upper || least < lower;
    }
};

/// Returns the thresholds for the maxima found so far. A bound beyond a threshold could
/// change the verdict, or a maximum by more than its accuracy: the slack or 5 % of the
/// scallop limit, 25 % of the tolerance.
/// \param rest greatest thickness found, mm.
/// \param gouge greatest depth found, mm.
RefinementThresholds refinement_thresholds(double rest, double gouge,
                                           const DeviationLimits& limits);

/// Input of the measurement, shared by all tiles.
struct Measured {
    const PartCharts& charts;         ///< of the part
    const SweepTree& tree;            ///< all sweeps
    const InitialRay& initial_ray;    ///< material before the first sweep
    const DeviationOptions& options;  ///< limits and resolution
    const PartDistance& distance;     ///< from the part
};

/// Returns the thresholds, widened by the maxima that were found meanwhile.
RefinementThresholds sharpened_thresholds(const RefinementThresholds& thresholds,
                                          const Extremes& found,
                                          const DeviationLimits& limits);

/// Returns the greatest curvatures of the part at the middle and the corners of a tile.
PartCharts::CurvatureBounds greatest_curvature(const PartCharts& charts,
                                               const PartTile& tile);

/// Whether the remaining material of a chart is not judged, by
/// DeviationOptions::skipped_facets.
bool is_skipped(const PartCharts& charts, std::uint32_t chart,
                const DeviationOptions& options);

/// Whether a thickness of `left` mm violates a limit.
bool is_beyond(double left, const DeviationLimits& limits);

/// Returns the thickness `left`, limited to the radius of the largest empty ball at the
/// ray's point, with its sign.
/// \param left in mm.
/// \param hint as in `PartDistance`.
double limited_thickness(double left, const PartRay& ray, const PartDistance& distance,
                         std::optional<std::size_t>& hint);

/// The measurement of one tile: cut rays at the middles of its cells, and bounds between
/// them.
class TileMeasure {
public:
    /// Cuts the rays of the tile. `tile` and everything in `measured` must outlive the
    /// object.
    TileMeasure(const Measured& measured, const PartTile& tile);

    /// Cuts the rays of several tiles; faster if neighbours follow each other.
    static std::vector<TileMeasure> measured_together(const Measured& measured,
                                                      std::span<const PartTile> tiles);

    /// The cells of the tile whose middle has a normal.
    std::span<const MeasuredCell> cells() const { return cells_; }

    /// The numbers of these cells in the tile.
    std::span<const int> numbers() const { return numbers_; }

    /// Limits the thickness of every cell's ray to its empty ball, exactly or by a close
    /// upper bound where that is much faster.
    /// \param hint as in `PartDistance`.
    void limit_thicknesses(std::optional<std::size_t>& hint);

    /// Returns the extremes of the cells, with bounds between their middles.
    Extremes extremes();

    /// Returns the extremes with every cell refined whose bounds exceed the thresholds.
    /// The empty ball of a ray is computed only where a limit is violated or a maximum in
    /// `known` exceeded.
    Extremes refined(const RefinementThresholds& thresholds,
                     const DeviationLimits& known);

    /// Returns the extremes of the rays of cells that are halved `times` times where a
    /// sweep comes near. It is used if no first ray is cut.
    Extremes halved(int times);

private:
    // Level of a cell in the refinement, with the sweeps that may matter to it.
    struct Depth {
        int level;       // number of halvings
        bool by_planes;  // the cell and its pieces need planes: border
        std::span<const std::int32_t> sweeps;   // those that may leave the least
        std::span<const std::int32_t> gouging;  // those that may clear the part
    };

    class Curvatures;
    TileMeasure(const Measured& measured, const PartTile& tile,
                const PartCharts::CurvatureBounds& curvature);
    void lay_out_rays();
    void take_rays();
    bool is_exhausted() const;
    bool is_outer(const PartRay& ray) const;
    bool is_inaccessible(const MeasuredCell& cell) const;
    void set_judged(MeasuredCell& cell) const;
    void limit_thickness(MeasuredCell& cell, const Extremes& found);
    void limit_side(double sign, std::optional<std::size_t>& hint);
    bool is_free(double sign, double length);
    double measured_free(double sign) const;
    bool is_smooth_within(double distance, const PartRay& middle) const;
    std::span<const std::int32_t> gouging();
    Extremes refined_to(int level, const RefinementThresholds& thresholds,
                        std::span<const std::int32_t> near);
    CutRay stock(const PartRay& ray) const { return measured_.initial_ray(ray); }
    const DeviationLimits& limits() const { return measured_.options.limits; }
    std::span<const StraightSweep> sweeps() const { return measured_.tree.sweeps(); }
    const Cutter& cutter_of(const MeasuredCell& cell) const
    {
        return sweeps()[static_cast<std::size_t>(cell.cut.sweep)].cutter();
    }
    double corner_radius();
    double most_left(const MeasuredCell& cell,
                     std::span<const std::int32_t> others) const;
    double most_left_by(const MeasuredCell& cell,
                        std::span<const std::int32_t> others) const;
    bool needs_planes(const MeasuredCell& cell);
    double least_left(const MeasuredCell& cell);
    double smooth_least(const MeasuredCell& cell);
    bool has_no_foot(const MeasuredCell& cell, double away) const;
    bool has_no_foot(const PartRay& ray, double reach, double curvature,
                     double away) const;
    bool clears_no_foot(const MeasuredCell& cell,
                        std::span<const std::int32_t> sweep_numbers, double away) const;
    void refine(const MeasuredCell& cell, const RefinementThresholds& first_thresholds,
                const Depth& depth, Extremes& found);
    void refine_quarters(const MeasuredCell& cell,
                         const RefinementThresholds& first_thresholds, const Depth& depth,
                         Extremes& found);
    void halve(const MeasuredCell& cell, int times, std::span<const std::int32_t> near,
               Extremes& found);
    MeasuredCell measured(const PartCell& cell, const PartRay& ray,
                          std::span<const std::int32_t> sweeps) const;

    Measured measured_;
    const PartTile& tile_;
    PartCharts::CurvatureBounds curvature_;
    bool touches_side_;
    bool is_wall_ = false;  // whether the whole tile is upright
    std::vector<MeasuredCell> cells_;
    std::vector<int> numbers_;
    std::optional<CutRays> rays_;
    std::optional<std::vector<std::int32_t>> gouging_;  // computed on first use
    std::optional<double> corner_radius_;               // computed on first use
    // Length up to which no ray is limited by its empty ball, along the normals and
    // against them, mm; computed on first use.
    std::array<std::optional<double>, 2> free_ = {};
    DeviationLimits known_ = {};
    std::size_t refined_cells_ = 0;
    int last_level_ = 0;
};

}  // namespace endmill
