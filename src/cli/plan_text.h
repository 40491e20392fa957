// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>

#include "cli/plan_summary.h"
#include "endmill/figures/tool_path_svg.h"

namespace endmill {

/// The first line of a report: part, cutter and its limit, mode and tolerances in force; in
/// mode paper also the form of the curvature across the feed.
std::string settings_text(const PlanContext& context, const PlanOptions& options);

/// The report on one direction.
std::string direction_text(const PlannedDirection& planned, const Json& summary);

/// The limits that the path along one direction misses: "along u: chord error, scallop".
std::string missed_text(const PlannedDirection& planned);

/// The line of the report that names the better mode than mode paper.
/// \param missed by missed_text, for each direction that misses a limit.
std::string better_mode_text(std::span<const std::string> missed);

/// The line of the report on the recommended direction.
std::string comparison_text(const Json& both);

/// Title and caption of the picture of one direction.
FigureOptions figure_options(const Json& summary);

}  // namespace endmill
