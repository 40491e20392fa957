// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "cli/plan_summary.h"
#include "endmill/figures/tool_path_svg.h"

namespace endmill {

/// What a plan says to a person: the largest ball and where it touches.
std::string limit_text(const std::optional<CutterLimit>& limit);

/// The cutter, the tolerances and the mode that are in force.
std::string settings_text(const PlanContext& context, const PlanOptions& options);

/// The summary of one direction.
std::string direction_text(const Json& summary);

/// What `add_comparison` found.
std::string comparison_text(const Json& both);

/// Title and caption of the drawing of a direction with that summary.
FigureOptions figure_options(const Json& summary);

}  // namespace endmill
