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

/// Properties of the surface that are known before planning.
struct PlanContext {
    std::string name;
    std::string source;
    SurfaceContinuity continuity;
    std::optional<CutterLimit> limit;
    double cutter_diameter;  ///< mm
    bool several;            ///< the part has several surfaces, each planned separately
};

/// The plan along one parameter and its measures.
struct PlannedDirection {
    Parameter along;
    PathEconomy economy;
    ChordError chord_error;
    MotionError motion_error;
    Deviation deviation;                  ///< of the part after the straight motions
    std::optional<double> tape_length_m;  ///< none unless the axis is +z
    std::size_t lifted_links = 0;
    std::vector<UncoveredPlace> uncovered = {};
};

/// Travel in mm between contacts or tips, with the links if `count_links`.
double counted_travel(const PathEconomy& economy, TravelKind kind, bool count_links);

/// summary.json of one direction.
Json direction_summary(const PlanContext& context, const PlanOptions& options,
                       const PlannedDirection& planned);

/// Adds `recommended`, `reduction_ncl` and `reduction_tcd` to `{"u": …, "v": …}`.
void add_comparison(Json& both, const PlanOptions& options, const PlannedDirection& u,
                    const PlannedDirection& v);

}  // namespace endmill
