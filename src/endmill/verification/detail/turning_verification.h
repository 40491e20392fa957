// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "endmill/stock/stock_history.h"
#include "endmill/verification/verification_result.h"
#include "endmill/verification/verification_task.h"

namespace endmill {

/// Verifies a path whose axis may turn, as `verify_path` does.
/// \pre path and part are not null.
Verification verify_turning_path(const VerificationTask& task);

/// Returns the block and the moves of all runs, those of `task` included; nothing if only the
/// heights of the stock before the path are known.
std::optional<TurningHistory> history_of_turning_rest(const VerificationTask& task);

}  // namespace endmill
