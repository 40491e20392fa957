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

/// Limits of the deviation.
struct DeviationLimits {
    double tolerance = 0.01;  ///< greatest allowed depth of a gouge, mm
    double scallop = 0.1;     ///< greatest allowed thickness of remaining material, mm
};

/// Both limits are raised by this length, in mm, before a verdict. Otherwise a path that
/// is planned exactly to a limit would stay undecided.
/// Source: docs/mathematics/removal.md, section 3.
inline constexpr double verdict_slack = 0.001;

/// Options of the measurement.
struct DeviationOptions {
    DeviationLimits limits = {};  ///< cells are refined until these are decided
    double pitch = 0.1;           ///< distance of the first rays along the part, mm
    int max_refine = 8;           ///< times that a cell may be halved, 0 to 20
    std::size_t most_cells = 100'000'000;  ///< limit of the first cells
    /// If set, it is called now and then with the finished share, 0 to 1.
    std::function<void(double share)> progress = {};
};

/// A place of the part with the material there.
struct DeviationPlace {
    double left = 0;           ///< thickness along the normal, mm; < 0: depth of a gouge
    PartRay ray{};             ///< point and normal of the part
    std::uint32_t chart = 0;   ///< number of the part's chart
    Eigen::Vector2d at{0, 0};  ///< parameters in that chart
    /// Number of the sweep that made the surface there; -1: the surface of the stock
    /// itself.
    std::int32_t sweep = -1;
};

/// Deviation of the remaining stock from a part.
struct Deviation {
    double max_gouge_mm = 0;  ///< greatest measured depth of a gouge; 0 if there is none
    double max_scallop_mm = 0;  ///< greatest measured thickness left; 0 if there is none
    /// Mean thickness left, weighted by area; a gouge counts as 0.
    double mean_scallop_mm = 0;
    double p99_scallop_mm = 0;  ///< 99 % of the area has less left; relative error 1e-3
    double gouge_area_mm2 = 0;  ///< area with a gouge deeper than the tolerance
    double uncut_area_mm2 = 0;  ///< area with more left than the scallop limit
    double area_mm2 = 0;        ///< area that was judged
    /// Error bound: no gouge is deeper than max_gouge_mm by more.
    double gouge_bound_mm = 0;
    /// Error bound: nowhere is more left than max_scallop_mm by more.
    double scallop_bound_mm = 0;
    double pitch_mm = 0;   ///< distance of the first rays
    std::size_t rays = 0;  ///< number of measured rays, with those of refined cells
    std::optional<DeviationPlace> deepest;  ///< the deepest gouge; none without a gouge
    /// The thickest material left; none without any.
    std::optional<DeviationPlace> highest;
    bool is_cut = false;  ///< whether a move reaches a ray of the part
    /// Whether one of the first rays ends at a move of the path, not of an earlier run.
    bool is_cut_by_path = false;

    std::vector<PartTile> tiles;  ///< the first cells, in tiles
    /// Thickness at the middle of each first cell, in the order of the tiles, mm; < 0:
    /// gouge.
    std::vector<float> left;
    /// Area of each first cell, mm^2; 0 for a cell that is not judged.
    std::vector<float> area;
};

/// Whether a path meets its limits.
enum class Verdict {
    Clean,   ///< certain: no gouge and no thickness beyond the limits
    Gouged,  ///< a gouge beyond the tolerance was measured
    /// A thickness beyond the scallop limit was measured, and no gouge beyond
    /// the tolerance is possible.
    Uncut,
    Undecided,  ///< the bounds allow a violation that was not measured
};

/// Returns the word for a verdict in files: "clean", "gouged", "uncut" or "undecided".
std::string_view verdict_name(Verdict verdict);

/// Returns the verdict on a deviation, with both limits raised by the slack. The first
/// rule that applies decides:
/// 1. `Gouged` if a measured gouge exceeds the tolerance;
/// 2. `Undecided` if the bound allows a deeper gouge than the tolerance;
/// 3. `Uncut` if a measured thickness exceeds the scallop limit;
/// 4. `Clean` if the bound excludes that, else `Undecided`. A finer grid can therefore
///    change no verdict except `Undecided`.
/// Source: docs/mathematics/removal.md, section 3.
Verdict verdict(const Deviation& deviation, const DeviationLimits& limits);

}  // namespace endmill
