// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "support/judged_path.h"

namespace endmill {

/// Named numbers in the order of a table's rows.
using NamedNumbers = std::vector<std::pair<std::string, double>>;

/// The defects of the path that the paper's planner makes over `surface`: chord errors and gouges
/// of its steps, the scallop of its passes (for a ball that rolls along them, and for its straight
/// motions), the number of points that correct steps need, and the travel of idealised passes.
/// \param rays approximate number of measuring rays for the scallop.
NamedNumbers weaknesses(const Surface& surface, const PlanToJudge& plan, double rays);

}  // namespace endmill
