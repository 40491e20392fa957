// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "cli/plan_summary.h"
#include "endmill/figures/tool_path_svg.h"

namespace endmill {

/// A line for a person: the limit of the ball's radius and its place.
std::string limit_text(const std::optional<CutterLimit>& limit);

/// The first line of a report: part, cutter, mode and tolerances in force.
std::string settings_text(const PlanContext& context, const PlanOptions& options);

/// The summary of one direction.
std::string direction_text(const Json& summary);

/// The direction that `add_comparison` recommends.
std::string comparison_text(const Json& both);

/// Title and caption of the drawing of a direction with that summary.
FigureOptions figure_options(const Json& summary);

}  // namespace endmill
