// SPDX-License-Identifier: GPL-3.0-or-later
// Internal to simulation
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "endmill/simulation/cell_bounds.h"
#include "endmill/simulation/deviation.h"
#include "endmill/simulation/part_distance.h"

namespace endmill {

/// What has been found on some cells.
struct Extremes {
    DeviationPlace highest{-std::numeric_limits<double>::infinity()};
    DeviationPlace deepest{std::numeric_limits<double>::infinity()};
    double upper = -std::numeric_limits<double>::infinity();  ///< mm; no rest is higher
    double lower = std::numeric_limits<double>::infinity();   ///< mm; no gouge is deeper
    double above = 0;      ///< most that a cell may have more than at its middle, mm
    double below = 0;      ///< the same for less
    bool is_cut = false;   ///< some move reaches a ray
    std::size_t rays = 0;  ///< measured

    /// Counts a ray in.
    void take(const MeasuredCell& cell)
    {
        ++rays;
        is_cut = is_cut || cell.left.sweep >= 0;
        const DeviationPlace place{cell.left.left, cell.ray, cell.cell.chart,
                                   cell.cell.centre(), cell.left.sweep};
        if (place.left > highest.left)
            highest = place;
        if (place.left < deepest.left)
            deepest = place;
    }
    /// Counts in what bounds the cell whose middle has `left`.
    void bound(double left, double most, double least)
    {
        upper = std::max(upper, most);
        lower = std::min(lower, least);
        above = std::max(above, most - left);
        below = std::max(below, left - least);
    }
    /// Counts in what was found of the same cells once more: all of it holds, and of the
    /// bounds the closer ones.
    void join(const Extremes& other)
    {
        const double most = std::min(upper, other.upper);
        const double least = std::max(lower, other.lower);
        merge(other);
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

/// The distance from the part of the place where the material ends, if that is less than
/// `left`, with its sign. \param hint as in PartDistance.
double shortened(double left, const PartRay& ray, const PartDistance& distance,
                 std::optional<std::size_t>& hint);

/// The rays of one tile, mown, and what may lie between them.
class TileMeasure {
public:
    /// Measures at once. What `measured` refers to, and `tile`, outlive it.
    TileMeasure(const Measured& measured, const PartTile& tile);

    /// The cells of the tile that have a normal.
    std::span<const MeasuredCell> cells() const { return cells_; }

    /// Their numbers in the tile.
    std::span<const int> numbers() const { return numbers_; }

    /// What the cells have, and what bounds it between their middles.
    Extremes extremes() const;

    /// The same with every doubtful cell refined.
    Extremes refined(const Doubt& doubt);

private:
    // How far a cell has been halved, and the sweeps that may matter to it.
    struct Depth {
        int level;
        std::span<const std::int32_t> sweeps;
    };

    void measure();
    bool is_exhausted() const;
    Extremes refined_to(int level, const Doubt& doubt,
                        std::span<const std::int32_t> near);
    MownRay stock(const PartRay& ray) const { return measured_.options.stock(ray); }
    const Cutter& cutter() const { return measured_.tree.sweeps().front().cutter(); }
    double most_left(const MeasuredCell& cell,
                     std::span<const std::int32_t> others) const;
    double most_left_by(const MeasuredCell& cell,
                        std::span<const std::int32_t> others) const;
    double least_left(const MeasuredCell& cell) const;
    Doubt sharpened(const Doubt& doubt, const Extremes& found) const;
    void refine(const MeasuredCell& cell, const Doubt& first_doubt, const Depth& depth,
                Extremes& found);
    MeasuredCell measured(const PartCell& cell, const PartRay& ray,
                          std::span<const std::int32_t> sweeps) const;

    Measured measured_;
    const PartTile& tile_;
    PartCharts::Bend bend_;
    std::vector<MeasuredCell> cells_;
    std::vector<int> numbers_;
    std::optional<MownRays> rays_;
    std::size_t refined_cells_ = 0;
    int last_level_ = 0;
};

}  // namespace endmill
