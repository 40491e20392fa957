// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>

#include "cli/plan_summary.h"
#include "endmill/files/output_folder.h"

namespace endmill {

/// The surfaces of a part, what is known of them, and what was asked.
struct PlanTask {
    std::span<const Surface> surfaces;
    const PlanContext& context;
    const PlanOptions& options;
};

/// A gouge deeper than the inner tolerance.
struct KnownGouge {
    Parameter along;  ///< direction of the passes
    double depth_mm;
};

/// A summary for programs and for a person.
struct PlanResult {
    Json summary;
    std::string text;
    std::size_t uncovered_places;     ///< where a verified plan does not hold
    std::optional<KnownGouge> gouge;  ///< the deepest, if a path is known to gouge
};

/// Plans along the parameters that were asked for, both at the same time if they fit into
/// memory, and writes the paths, their pictures and summaries into `folder`, in the place
/// of what an earlier run left there.
/// \throws LimitError before the work if the path would not fit the memory, and as
/// plan_iso_parametric.
PlanResult write_plan(const PlanTask& task, OutputFolder& folder);

}  // namespace endmill
