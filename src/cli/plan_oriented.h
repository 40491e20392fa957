// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/plan_files.h"

namespace endmill {

/// Plans a path whose axis turns, on surfaces along u or v as asked, or along the one with the shorter
/// cuts of the clean paths. Writes path, picture and summary into `folder`.
/// \throws as plan_judged_oriented.
PlanResult write_oriented_plan(const PlanTask& task, OutputFolder& folder);

}  // namespace endmill
