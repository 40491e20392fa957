// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cli/plan_options.h"
#include "endmill/deviation/deviation.h"
#include "endmill/planning/economy.h"
#include "endmill/planning/path_error.h"
#include "endmill/planning/verified_plan.h"
#include "endmill/surface/continuity.h"
#include "endmill/surface/largest_cutter.h"

namespace endmill {

/// Properties of the surface that are known before planning.
struct PlanContext {
    std::string name;
    std::string source;
    SurfaceContinuity continuity;
    std::optional<CutterLimit> limit;
    Cutter cutter;
    bool several;          ///< the part has several surfaces, each planned separately
    bool is_mesh = false;  ///< the part has no curvature and no continuity

    /// The ball. \pre the cutter is one.
    BallCutter ball() const { return BallCutter{cutter.radius()}; }
};

/// The plan along one parameter and its measures.
struct PlannedDirection {
    Parameter along;
    PathEconomy economy;
    ChordError chord_error;
    MotionError motion_error;
    Deviation deviation;                  ///< of the part after the straight motions
    std::optional<double> tape_length_m;  ///< none unless the axis is +z
    std::set<PathLimit> missed;           ///< limits that the errors exceed
    std::size_t lifted_links;
    std::vector<UncoveredPlace> uncovered;  ///< empty in mode paper

    /// The errors along the passes and on the whole part.
    PathErrors errors() const;
};

/// summary.json of one direction.
Json direction_summary(const PlanContext& context, const PlanOptions& options,
                       const PlannedDirection& planned);

/// Adds `recommended`, `reduction_ncl` and `reduction_tcd` to `{"u": …, "v": …}`.
void add_comparison(Json& both, const PlanOptions& options, const PlannedDirection& u,
                    const PlannedDirection& v);

}  // namespace endmill
