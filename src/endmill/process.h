// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// \file
/// All public headers of the module `process`.

#include "endmill/process/ball_engagement.h"
#include "endmill/process/cutting_coefficients.h"
#include "endmill/process/cutting_force.h"
#include "endmill/process/fed_path.h"
#include "endmill/process/feed_limits.h"
#include "endmill/process/feed_plan.h"
#include "endmill/process/milling_data.h"
#include "endmill/process/segment_cuts.h"
#include "endmill/process/tool_life.h"
