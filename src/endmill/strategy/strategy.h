// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "endmill/cutter/cutter.h"
#include "endmill/path/tool_path.h"
#include "endmill/planning/linking.h"
#include "endmill/planning/verified_plan.h"
#include "endmill/surface/surface.h"

/// \file
/// Plans paths whose passes lie where the passes before leave the allowed height.

namespace endmill {

/// Options of a strategy.
struct StrategyOptions {
    /// Largest height of remaining material in mm, along the normal, all causes together.
    double scallop_height = 0.01;
    double inner_tolerance = 0.01;  ///< greatest gouge depth, anywhere on the part, mm
    LinkOptions link = {};          ///< tool axis and safe height
    std::size_t most_points = 40'000'000;   ///< a longer path throws LimitError
    std::size_t most_samples = 20'000'000;  ///< a part that needs more throws LimitError
    /// If set, it is called with the finished share, 0 to 1.
    std::function<void(double share)> progress = {};
};

/// A path by a strategy, and what it leaves.
struct StrategyPlan {
    ToolPath path;           ///< all pieces and the links between them
    std::size_t passes = 0;  ///< passes as laid, before they are divided
    /// How far a centre of the ball may be from its place above the contact, mm: by a gouge
    /// or by a lift.
    double stray_mm = 0;
    std::size_t pieces = 0;        ///< parts of passes that are cut in contact throughout
    std::size_t lifted_links = 0;  ///< links that are lifted because they are not clear
    /// Area in mm^2 of the parts of the sampled surface in which a place was found that
    /// keeps more than the scallop height.
    double uncovered_mm2 = 0;
    std::vector<UncoveredPlace> uncovered = {};  ///< these places, the worst of each part
};

/// The greatest number of samples of a part for which `memory_gib` suffices.
std::size_t most_part_samples(double memory_gib);

/// Plans passes of equal scallop height: each lies as far as possible from the passes
/// before it. Passes are level lines of the distance from what is covered; they branch,
/// merge and run around holes. Several starts are tried: all borders at once, each side of
/// the border, and straight lines of several directions. The shortest result is returned.
/// Source: docs/methods/iso-scallop.md, section 2.
/// \param surfaces the part; at least one.
/// \param cutter   the ball.
/// \param options  see there.
/// \throws DomainError if a tolerance, the height or the axis is out of range.
/// \throws GeometryError with the place if N . axis <= 0 or the surface has no normal.
/// \throws LimitError if the part needs too many samples or points.
StrategyPlan plan_iso_scallop(std::span<const Surface> surfaces, const BallCutter& cutter,
                              const StrategyOptions& options);

}  // namespace endmill
