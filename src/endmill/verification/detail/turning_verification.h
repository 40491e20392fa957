// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/verification/verification_result.h"
#include "endmill/verification/verification_task.h"

namespace endmill {

/// Verifies a path whose axis may turn, as `verify_path` does.
/// \pre path and part are not null.
Verification verify_turning_path(const VerificationTask& task);

}  // namespace endmill
