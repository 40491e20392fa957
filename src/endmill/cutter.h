// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// \file
/// All public headers of the module `cutter`.

#include "endmill/cutter/cutter.h"
#include "endmill/cutter/cutting_body.h"
#include "endmill/cutter/engagement.h"
#include "endmill/cutter/plane_offset.h"
#include "endmill/cutter/straight_sweep.h"
#include "endmill/cutter/tool.h"
