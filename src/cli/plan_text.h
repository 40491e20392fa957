// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "cli/plan_summary.h"
#include "endmill/figures/tool_path_svg.h"

namespace endmill {

/// The line of the report on the limit of the ball's radius.
std::string limit_text(const std::optional<CutterLimit>& limit);

/// The first line of a report: part, cutter, mode and tolerances in force.
std::string settings_text(const PlanContext& context, const PlanOptions& options);

/// The report on one direction.
std::string direction_text(const Json& summary);

/// The line of the report on the recommended direction.
std::string comparison_text(const Json& both);

/// Title and caption of the picture of one direction.
FigureOptions figure_options(const Json& summary);

}  // namespace endmill
