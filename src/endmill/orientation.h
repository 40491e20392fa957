// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// \file
/// All public headers of the module `orientation`.

#include "endmill/orientation/axis_field.h"
#include "endmill/orientation/axis_reach.h"
#include "endmill/orientation/inclination.h"
#include "endmill/orientation/indexed_path.h"
#include "endmill/orientation/indexed_plan.h"
#include "endmill/orientation/oriented_options.h"
#include "endmill/orientation/oriented_path.h"
#include "endmill/orientation/setup_regions.h"
