// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "support/judged_path.h"

namespace endmill {

/// Numbers by what they measure, in the order of a table's rows.
using NamedNumbers = std::vector<std::pair<std::string, double>>;

/// Where the path that the paper plans over `surface` falls short of what it is planned
/// for: chords and straight motions of its steps, the scallop of passes that a ball rolls
/// along without chords and of its straight motions, and points that verified steps need.
/// \param rays about so many measure the scallop.
NamedNumbers weaknesses(const Surface& surface, const PlanToJudge& plan, double rays);

}  // namespace endmill
