// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// \file
/// All public headers of the module `verification`.

#include "endmill/verification/verification.h"
#include "endmill/verification/verification_result.h"
#include "endmill/verification/verification_task.h"
