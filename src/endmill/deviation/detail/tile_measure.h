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

/// What has been found on some cells.
struct Extremes {
    DeviationPlace highest{-std::numeric_limits<double>::infinity()};
    DeviationPlace deepest{std::numeric_limits<double>::infinity()};
    double upper = -std::numeric_limits<double>::infinity();  ///< mm; no rest is higher
    double lower = std::numeric_limits<double>::infinity();   ///< mm; no gouge is deeper
    double gouge_area = 0;  ///< mm^2 of cells deeper than the tolerance
    double uncut_area = 0;  ///< mm^2 of cells higher than the scallop limit
    double top = -std::numeric_limits<double>::infinity();  ///< of the cells, mm
    bool is_cut = false;                                    ///< some move reaches a ray
    std::size_t rays = 0;                                   ///< measured

    /// Counts a ray in.
    void take(const MeasuredCell& cell)
    {
        ++rays;
        top = std::max(top, cell.ray.point.z() + cell.reach);
        is_cut = is_cut || cell.left.sweep >= 0;
        take(DeviationPlace{cell.value(), cell.ray, cell.cell.chart, cell.cell.centre(),
                            cell.left.sweep});
    }
    void take(const DeviationPlace& place)
    {
        if (place.left > highest.left)
            highest = place;
        if (place.left < deepest.left)
            deepest = place;
    }
    /// Counts in what bounds a cell.
    void bound(double most, double least)
    {
        upper = std::max(upper, most);
        lower = std::min(lower, least);
    }
    /// Counts in a cell of so many mm^2 where so much is left.
    void add_area(double left, double area, const DeviationLimits& limits)
    {
        if (-left > limits.tolerance)
            gouge_area += area;
        if (left > limits.scallop)
            uncut_area += area;
    }
    /// Counts in what was found of the same cells once more: all of it holds, and of the
    /// bounds the closer ones, of the areas the larger.
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
    /// Of equal ones the first stays, so the order of the tiles decides.
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

/// Bounds beyond which a cell has to be looked at more closely.
struct Doubt {
    double upper;  ///< mm
    double lower;  ///< mm

    /// Whether a cell with these bounds is in doubt.
    bool holds(double most, double least) const { return most > upper || least < lower; }
};

/// The doubt that is left when `rest` and `gouge` (mm) are the greatest found so far:
/// beyond it lies what could change the verdict, or a maximum by more than its sharpness.
Doubt doubt_beyond(double rest, double gouge, const DeviationLimits& limits);

/// What is measured, and how.
struct Measured {
    const PartCharts& charts;
    const SweepTree& tree;
    const DeviationOptions& options;
    const PartDistance& distance;
};

/// Whether a limit is broken where `left` mm are left.
bool is_beyond(double left, const DeviationLimits& limits);

/// The way along the normal to where the material ends, as far as the ray's point is the
/// part's nearest place all the way: `left`, or less, with its sign.
/// \param hint as in PartDistance.
double shortened(double left, const PartRay& ray, const PartDistance& distance,
                 std::optional<std::size_t>& hint);

/// What is left counts as it is if it is less, in mm.
inline constexpr double negligible_length = 1e-6;

/// The rays of one tile, mown, and what may lie between them.
class TileMeasure {
public:
    /// Measures at once. What `measured` refers to, and `tile`, outlive it.
    TileMeasure(const Measured& measured, const PartTile& tile);

    /// The same for several tiles, sooner where neighbours follow each other.
    static std::vector<TileMeasure> measured_together(const Measured& measured,
                                                      std::span<const PartTile> tiles);

    /// The cells of the tile that have a normal.
    std::span<const MeasuredCell> cells() const { return cells_; }

    /// Their numbers in the tile.
    std::span<const int> numbers() const { return numbers_; }

    /// Finds what counts of the cells' rays: to a close bound, where that is much quicker.
    /// \param hint as in PartDistance.
    void count(std::optional<std::size_t>& hint);

    /// What the cells have, and what bounds it between their middles.
    Extremes extremes();

    /// The same with every doubtful cell refined. What counts of a ray is measured where a
    /// limit is broken or more is left, or taken, than is `known`, and only there.
    Extremes refined(const Doubt& doubt, const DeviationLimits& known);

    /// What the rays of its cells, halved so many times wherever a sweep comes near, find:
    /// where no first ray is cut.
    Extremes halved(int times);

private:
    // How far a cell has been halved, and the sweeps that may matter to it.
    struct Depth {
        int level;
        bool by_planes;  // all of its pieces too: it lies along the border
        std::span<const std::int32_t> sweeps;   // that may leave least
        std::span<const std::int32_t> beneath;  // that may clear the part
    };

    struct NotYetMown {};
    TileMeasure(const Measured& measured, const PartTile& tile, NotYetMown);
    void lay_out_rays();
    void take_rays();
    bool is_exhausted() const;
    bool is_outer(const PartRay& ray) const;
    void find_nearer(MeasuredCell& cell, const Extremes& found);
    void count_side(double sign, std::optional<std::size_t>& hint);
    bool is_free(double sign, double length);
    double measured_free(double sign) const;
    bool is_smooth_within(double distance, const PartRay& middle) const;
    std::span<const std::int32_t> beneath();
    Extremes refined_to(int level, const Doubt& doubt,
                        std::span<const std::int32_t> near);
    MownRay stock(const PartRay& ray) const { return measured_.options.stock(ray); }
    const DeviationLimits& limits() const { return measured_.options.limits; }
    std::span<const StraightSweep> sweeps() const { return measured_.tree.sweeps(); }
    const Cutter& cutter_of(const MeasuredCell& cell) const
    {
        return sweeps()[static_cast<std::size_t>(cell.left.sweep)].cutter();
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
    Doubt sharpened(const Doubt& doubt, const Extremes& found) const;
    void refine(const MeasuredCell& cell, const Doubt& first_doubt, const Depth& depth,
                Extremes& found);
    void refine_quarters(const MeasuredCell& cell, const Doubt& first_doubt,
                         const Depth& depth, Extremes& found);
    void halve(const MeasuredCell& cell, int times, std::span<const std::int32_t> near,
               Extremes& found);
    MeasuredCell measured(const PartCell& cell, const PartRay& ray,
                          std::span<const std::int32_t> sweeps) const;

    Measured measured_;
    const PartTile& tile_;
    PartCharts::Bend bend_;
    bool touches_side_;
    bool is_wall_ = false;  // upright all over
    std::vector<MeasuredCell> cells_;
    std::vector<int> numbers_;
    std::optional<MownRays> rays_;
    std::optional<std::vector<std::int32_t>> beneath_;  // found when first asked for
    std::optional<double> corner_radius_;               // ditto
    // How far all rays are free along the normals and against them, mm.
    std::array<std::optional<double>, 2> free_ = {};
    DeviationLimits known_ = {};
    std::size_t refined_cells_ = 0;
    int last_level_ = 0;
};

}  // namespace endmill
