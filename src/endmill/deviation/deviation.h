// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "endmill/deviation/detail/cut_ray.h"
#include "endmill/deviation/detail/part_tiles.h"
#include "endmill/stock/detail/sweep_tree.h"

namespace endmill {

/// What a path may leave and take.
struct DeviationLimits {
    double tolerance = 0.01;  ///< deepest gouge, mm
    double scallop = 0.1;     ///< highest rest of material, mm
};

/// Both limits are raised by this much, in mm, before a verdict: a path that is planned to
/// just a limit must not stay undecided. Source: spec of the removal, section 3.
inline constexpr double verdict_slack = 0.001;

/// How a deviation is measured.
struct DeviationOptions {
    DeviationLimits limits = {};
    double pitch = 0.1;  ///< of the first rays along the part, mm
    int max_refine = 8;  ///< halvings of a cell at most, 0 to 20
    /// What of a ray lies in the stock before any move: a finite length. Must be set.
    std::function<MownRay(const PartRay&)> stock = {};
    std::size_t most_cells = 100'000'000;  ///< beyond it LimitError is thrown
    /// So many of the sweeps, the first, were made by earlier runs.
    std::size_t earlier_sweeps = 0;
    std::function<void(double share)> progress = {};  ///< called now and then, if set
};

/// A place of the part and what is left there.
struct DeviationPlace {
    double left = 0;           ///< mm along the normal; negative: taken away
    PartRay ray{};             ///< there
    std::uint32_t chart = 0;   ///< of the part's charts
    Eigen::Vector2d at{0, 0};  ///< in that chart's parameters
    std::int32_t sweep = -1;   ///< the sweep that made it; none: the stock's own surface
};

/// What a path leaves on a part.
struct Deviation {
    double max_gouge_mm = 0;      ///< deepest found, 0 if none
    double max_scallop_mm = 0;    ///< highest rest found, 0 if none
    double mean_scallop_mm = 0;   ///< rests, weighted by area
    double p99_scallop_mm = 0;    ///< 99 % of the area has less; relative error 1e-3
    double gouge_area_mm2 = 0;    ///< deeper than the tolerance
    double uncut_area_mm2 = 0;    ///< higher than the scallop limit
    double area_mm2 = 0;          ///< judged
    double gouge_bound_mm = 0;    ///< no gouge is deeper than max_gouge_mm by more
    double scallop_bound_mm = 0;  ///< no rest is higher than max_scallop_mm by more
    double pitch_mm = 0;          ///< of the first rays
    std::size_t rays = 0;         ///< measured, with those of refined cells
    std::optional<DeviationPlace> deepest;  ///< none without a gouge
    std::optional<DeviationPlace> highest;  ///< none without a rest
    bool is_cut = false;                    ///< some move reaches the part's rays at all
    /// Of the first rays one ends at a move that is none of an earlier run.
    bool is_cut_by_path = false;

    /// The first cells and what is left at their middles, in the order of the tiles.
    std::vector<PartTile> tiles;
    std::vector<float> left;  ///< mm
    std::vector<float> area;  ///< mm^2
};

/// Measures what the sweeps of `tree` leave of the stock on the part, along the part's own
/// normals: at the middles of cells of `pitch`, and finer where what may lie between two
/// rays could change the verdict, or either maximum by more than the slack and a twentieth
/// of its limit.
///
/// Of what is left along the normal, only as much counts as the ray's own point stays the
/// part's nearest place, the radius of a ball between the end of the material and the part:
/// beside a wall, in a corner or on a narrow ridge, the ray of one face may end near
/// another. That holds for every ray and hangs on no limit; the maxima are measured so,
/// other rays to about 1 % where that is much quicker. Once a gouge is known nothing is
/// refined; once too much is known to be left, only for gouges. The areas of both are those
/// of the finest cells.
///
/// Between rays on a smooth piece of the part a round corner hides a gouge of at most
/// (d^2 / 2)(1 / r + k), d a cell's half diagonal, r the cutter's corner radius, k the
/// part's convex curvature. Where that does not hold (a sharp edge, a crease or side of a
/// patch or triangle, a cell that is not small against r) every sweep near the cell is
/// held off by a plane, or counts as deep as that plane allows. A rest is no more than the
/// part's and the sweeps' own shape allows: above a flat piece of the part what one sweep
/// leaves is convex, so its highest place is a cell's corner. Curvature of the part over a
/// cell enters by d^2 k.
///
/// Where no ray meets a move, cells that one comes near are halved until one does.
///
/// In refined cells half a first cell along where the part ends (sides of surfaces that meet
/// no other, edges of one triangle) is not judged: what stands there is no gouge and no
/// rest, but the bounds hold for it too, for a finer grid would judge it. On upright outer
/// walls of the part, beside which half a pitch away there is no part over or under, rests
/// are not judged: no path over the part can reach the stock there. They count as 0 and
/// have no area.
/// Source: spec of the removal, section 2, 3; the bounds are derived in
/// paper/notes/deviation-bounds.md.
/// \throws DomainError for options out of range, LimitError for too many cells.
Deviation measure_deviation(const PartCharts& charts, const SweepTree& tree,
                            const DeviationOptions& options);

/// Whether a path has done what was asked.
enum class Verdict { Clean, Gouged, Uncut, Undecided };

/// The word for it in files: "clean", "gouged", "uncut" or "undecided".
std::string_view verdict_name(Verdict verdict);

/// The first that applies, with both limits raised by the slack: gouged by a measured point,
/// undecided while the bound leaves room for a gouge, uncut by a measured point, clean if the
/// bounds say so, else undecided. So a finer grid changes none but undecided.
/// Source: spec of the removal, section 3.
Verdict verdict(const Deviation& deviation, const DeviationLimits& limits);

}  // namespace endmill
