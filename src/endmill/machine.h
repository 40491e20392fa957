// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// \file
/// All public headers of the module `machine`.

#include "endmill/machine/axis_limits.h"
#include "endmill/machine/configuration.h"
#include "endmill/machine/feasible_directions.h"
#include "endmill/machine/kinematics.h"
#include "endmill/machine/tool_motion.h"
