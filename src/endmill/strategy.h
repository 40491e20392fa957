// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// \file
/// All public headers of the module `strategy`.

#include "endmill/strategy/plan_frame.h"
#include "endmill/strategy/protected_part.h"
#include "endmill/strategy/strategy.h"
#include "endmill/strategy/strategy_options.h"
#include "endmill/strategy/strip_use.h"
