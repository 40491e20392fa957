// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// \file
/// All public headers of the module `core`.

#include "endmill/core/angle.h"
#include "endmill/core/answer.h"
#include "endmill/core/error.h"
#include "endmill/core/orientation.h"
#include "endmill/core/parallel.h"
#include "endmill/core/text.h"
#include "endmill/core/tolerance.h"
#include "endmill/core/vec.h"
