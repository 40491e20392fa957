// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "endmill/cutter/cutter.h"
#include "endmill/orientation/setup_regions.h"
#include "endmill/path/tool_path.h"
#include "endmill/strategy/strategy.h"

/// \file
/// Plans a part from several fixed directions (3+2 axes): facets are assigned to directions,
/// each direction is planned as a three-axis path, and the paths are joined to one.

namespace endmill {

/// Options of `plan_indexed`.
struct IndexedOptions {
    std::vector<Vec3> directions;           ///< unit, from the part to the spindle
    std::vector<std::size_t> skipped = {};  ///< facets that are not cut, ascending
    std::optional<Strategy> strategy = {};  ///< of each direction; nothing: the best one
    double scallop_height = 0.1;            ///< mm along the normal, above 0
    double inner_tolerance = 0.01;          ///< mm, greatest depth of a gouge; above 0
    TravelKind distance = TravelKind::Contact;  ///< the length that is kept short
    double clearance = 5;                   ///< mm, of rapids above the stock; above 0
    std::size_t most_points = 40'000'000;   ///< a longer path throws LimitError
    std::size_t most_samples = 20'000'000;  ///< a part that needs more throws LimitError
    /// If set, it is called with the finished share, 0 to 1.
    std::function<void(double share)> progress = {};
};

/// The path from one direction.
struct IndexedCut {
    std::size_t direction;            ///< number of the direction
    std::vector<std::size_t> facets;  ///< that are assigned to it, ascending
    std::optional<BestPlan> best;     ///< the plan; nothing if there is none
    std::string refusal = {};         ///< why there is no plan; else empty
};

/// A path from several directions.
struct IndexedPlan {
    ToolPath path;  ///< in the coordinates of the part; empty if nothing can be cut
    /// The directions that cut facets, in their order.
    std::vector<IndexedCut> cuts;
    /// Facets that no direction sees, or that a direction without a plan would cut; ascending.
    std::vector<std::size_t> uncovered;
    std::size_t joined_regions = 0;  ///< small regions that joined a neighbour

    /// Whether every facet is cut and every plan is judged good.
    bool is_good() const;
};

/// Plans a part from several directions.
///
/// `setup_regions` assigns the facets, and prefers directions from which the ball comes within
/// half the scallop height of the middle of a facet. A facet with a place that the ball reaches
/// from another direction only is cut from there too. The facets of a direction, and a strip of one path
/// interval over their border, are planned as a part that stands with the direction upright,
/// by `plan_in_frame`; the whole mesh is protected. Each plan is judged as a three-axis path
/// that starts from the full block. One that is not good is made again for 0.8 of the scallop
/// height, up to twice. `indexed_path` joins the paths; the tool turns outside a ball
/// around the block of `default_block`. If a direction has no plan, the others are returned.
/// Source: docs/methods/five-axis-planning.md, section 6.
/// \param part closed and oriented outwards.
/// \throws DomainError for options out of range; as setup_regions.
/// \throws LimitError as plan_by_strategy.
IndexedPlan plan_indexed(const TriangleMesh& part, const BallCutter& cutter,
                         const IndexedOptions& options);

}  // namespace endmill
