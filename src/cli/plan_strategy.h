// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "cli/plan_files.h"
#include "endmill/strategy/strategy_options.h"

namespace endmill {

/// Plans by `options.strategy`, which is not the planner along parameter lines, measures the
/// path and writes it with its picture and summary into `folder`.
/// \throws LimitError and GeometryError as the strategy.
PlanResult write_strategy_plan(const PlanTask& task, OutputFolder& folder);

/// The strategy of a plan; nothing if the best is searched for.
std::optional<Strategy> chosen_strategy(StrategyChoice strategy);

}  // namespace endmill
