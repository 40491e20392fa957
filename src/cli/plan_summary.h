// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "cli/plan_options.h"
#include "endmill/deviation/deviation.h"
#include "endmill/planning/economy.h"
#include "endmill/planning/path_error.h"
#include "endmill/surface/continuity.h"
#include "endmill/surface/largest_cutter.h"

namespace endmill {

/// What is known of the surface before it is planned on.
struct PlanContext {
    std::string name;
    std::string source;
    SurfaceContinuity continuity;
    std::optional<CutterLimit> limit;
    double cutter_diameter;  ///< mm
    bool several;            ///< surfaces, each planned by itself
};

/// What was planned along one parameter.
struct PlannedDirection {
    Parameter along;
    PathEconomy economy;
    ChordError chord_error;
    MotionError motion_error;
    Deviation deviation;  ///< of what the straight motions leave of a block
    std::optional<double> tape_length_m;  ///< none for an axis that G-code cannot have
    std::size_t lifted_links = 0;
    std::vector<UncoveredPlace> uncovered = {};
};

/// Travel in mm with the links if they count, by contacts or by tips.
double counted_travel(const PathEconomy& economy, TravelKind kind, bool count_links);

/// summary.json of one direction.
Json direction_summary(const PlanContext& context, const PlanOptions& options,
                       const PlannedDirection& planned);

/// Adds `recommended`, `reduction_ncl` and `reduction_tcd` to `{"u": …, "v": …}`.
void add_comparison(Json& both, const PlanOptions& options, const PlannedDirection& u,
                    const PlannedDirection& v);

}  // namespace endmill
