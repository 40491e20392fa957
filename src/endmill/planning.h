// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// \file
/// All public headers of the module `planning`.

#include "endmill/planning/economy.h"
#include "endmill/planning/iso_parametric.h"
#include "endmill/planning/linking.h"
#include "endmill/planning/path_error.h"
#include "endmill/planning/path_interval.h"
#include "endmill/planning/planned_path.h"
#include "endmill/planning/planner_options.h"
#include "endmill/planning/step_length.h"
#include "endmill/planning/verified_plan.h"
