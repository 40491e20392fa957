// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "endmill/deviation/part_charts.h"

/// \file
/// The deviation of a machined surface from the part, and the verdict on it.
/// `deviation_in_block` and `verify_path` of the module `verification` measure it.

namespace endmill {

/// Depth in mm that stands for a tolerance of 0 in `DeviationLimits`. It is far below
/// `verdict_slack`, which every verdict adds, and above the rounding of coordinates.
inline constexpr double no_gouge_tolerance = 1e-7;

/// Limits of the deviation.
struct DeviationLimits {
    double tolerance = 0.01;  ///< greatest allowed depth of a gouge, mm; above 0
    double scallop = 0.1;     ///< greatest allowed thickness of remaining stock, mm
};

/// Share of the limit of remaining stock. Where no more remains, the cutter has reached the
/// part.
inline constexpr double reached_share = 0.5;

/// Options of the measurement.
struct DeviationOptions {
    DeviationLimits limits = {};  ///< cells are refined until the verdict is certain
    double pitch = 0.1;           ///< distance of the first rays along the part, mm
    int max_refine = 8;           ///< largest number of halvings of a cell, 0 to 20
    std::size_t most_cells = 100'000'000;  ///< limit of the first cells
    /// Whether the cutter can reach a place of the part. If set, a cell is judged for
    /// remaining stock only if this returns true for its middle, or if at most
    /// `reached_share` of the limit remains there. Remaining stock in the accessible part of
    /// other cells is not bounded. Called by several threads at once.
    std::function<bool(const PartRay& ray)> is_accessible = {};
    /// Triangles of a mesh, ascending, whose remaining stock is not judged. Gouges are.
    std::vector<std::size_t> skipped_facets = {};
    /// If set, it is called with the finished share, 0 to 1.
    std::function<void(double share)> progress = {};
};

/// A place of the part, and the remaining stock there.
struct DeviationPlace {
    double left = 0;           ///< mm along the normal; > 0: remaining stock, < 0: gouge
    PartRay ray{};             ///< point and normal of the part
    std::uint32_t chart = 0;   ///< number of the part's chart
    Eigen::Vector2d at{0, 0};  ///< parameters in that chart
    /// Number of the sweep that made the surface there; -1: the surface of the stock
    /// itself.
    std::int32_t sweep = -1;
};

/// Deviation of the remaining stock from a part.
struct Deviation {
    double max_gouge_mm = 0;    ///< greatest measured depth of a gouge; 0 if none
    double max_scallop_mm = 0;  ///< greatest remaining stock measured; 0 if none
    /// Mean remaining stock, weighted by area; a gouge counts as 0.
    double mean_scallop_mm = 0;
    /// 99 % of the area has less remaining stock than this. Relative error 1e-3.
    double p99_scallop_mm = 0;
    double gouge_area_mm2 = 0;  ///< area with a gouge deeper than the tolerance
    double uncut_area_mm2 = 0;  ///< area with more remaining stock than the limit
    double area_mm2 = 0;        ///< area that was judged
    /// Area that the cutter has not reached and cannot reach, where remaining stock is not
    /// judged; 0 unless DeviationOptions::is_accessible is set.
    double inaccessible_area_mm2 = 0;
    /// Greatest remaining stock there, at the first rays, mm. Relative error 0.01.
    double max_inaccessible_mm = 0;
    /// Error bound: the true greatest depth exceeds max_gouge_mm by at most this.
    double gouge_bound_mm = 0;
    /// Error bound: the true greatest remaining stock exceeds max_scallop_mm by at most
    /// this.
    double scallop_bound_mm = 0;
    double pitch_mm = 0;   ///< distance of the first rays
    std::size_t rays = 0;  ///< number of measured rays, with those of refined cells
    std::optional<DeviationPlace> deepest;  ///< the deepest gouge; none without a gouge
    /// The greatest remaining stock; none without any.
    std::optional<DeviationPlace> highest;
    bool is_cut = false;  ///< whether a move reaches a ray of the part
    /// Whether one of the first rays ends at a move of this path rather than of an
    /// earlier run.
    bool is_cut_by_path = false;

    std::vector<PartTile> tiles;  ///< the first cells, in tiles
    /// Remaining stock at the middle of each first cell, in mm, in the order of the
    /// tiles; negative in a gouge.
    std::vector<float> left;
    /// Area of each first cell, mm^2; 0 for a cell that is not judged.
    std::vector<float> area;
};

/// Whether a path meets its limits.
enum class Verdict {
    Clean,   ///< certain: no gouge and no remaining stock beyond the limits
    Gouged,  ///< a gouge beyond the tolerance was measured
    /// Remaining stock beyond the scallop limit was measured, and no gouge beyond the
    /// tolerance is possible.
    Uncut,
    Undecided,  ///< the bounds allow a violation that was not measured
    NotJudged,  ///< there is no part with which the stock could be compared
    /// There is no part, and a rapid cuts, or shank or holder is in the stock.
    Collides,
};

/// Returns the word for a verdict in files: "clean", "gouged", "uncut", "undecided",
/// "not judged" or "collides".
std::string_view verdict_name(Verdict verdict);

/// Returns the verdict on a deviation, with both limits raised by `verdict_slack`. The first
/// rule that applies decides:
/// 1. `Gouged` if a measured gouge exceeds the tolerance;
/// 2. `Undecided` if the bound allows a deeper gouge than the tolerance;
/// 3. `Uncut` if the measured remaining stock exceeds the scallop limit;
/// 4. `Clean` if the bound excludes more remaining stock than the limit, else
///    `Undecided`.
///
/// A finer grid can therefore change no verdict except `Undecided`.
/// Source: docs/methods/removal.md, section 3.
Verdict verdict(const Deviation& deviation, const DeviationLimits& limits);

/// Which error bounds were refined until the verdict was certain. A measured gouge beyond
/// the tolerance decides the verdict, and measured stock beyond the scallop limit decides
/// whether the part is uncut. The bounds that cannot change the verdict any more keep the
/// values of the first rays.
struct RefinedBounds {
    bool gouge_is_refined;    ///< whether gouge_bound_mm was refined
    bool scallop_is_refined;  ///< whether scallop_bound_mm was refined
};

/// Returns which bounds of `deviation` were refined.
/// \param limits the limits with which it was measured.
RefinedBounds refined_bounds(const Deviation& deviation, const DeviationLimits& limits);

}  // namespace endmill
