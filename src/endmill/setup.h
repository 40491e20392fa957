// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// \file
/// All public headers of the module `setup`.

#include "endmill/setup/clamping.h"
#include "endmill/setup/path_setup.h"
#include "endmill/setup/pose_search.h"
#include "endmill/setup/setup.h"
#include "endmill/setup/setup_pose.h"
#include "endmill/setup/setup_travel.h"
#include "endmill/setup/several_setups.h"
#include "endmill/setup/whole_cone_search.h"
