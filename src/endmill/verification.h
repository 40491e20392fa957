// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// \file
/// All public headers of the module `verification`.

#include "endmill/verification/part_collisions.h"
#include "endmill/verification/upright.h"
#include "endmill/verification/verification.h"
